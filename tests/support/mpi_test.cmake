# softwall_add_mpi_test(NAME pressure_tests SOURCES poisson_test.cpp ... RANKS 1 2 4)
#   one GoogleTest executable, run as NAME.ranks<N> under mpirun for each number of ranks.
#   SINGLE: with the solver's single precision.
#   SANITIZED 1 2: the numbers of ranks that are tried with sanitizers, too; one unless said otherwise, since what
#   several ranks add is tested without, and instrumented ranks on few cores take minutes to wait. The others have the
#   label "ranks".
include_guard(GLOBAL)

add_library(softwall_test_support STATIC ${CMAKE_CURRENT_LIST_DIR}/mpi_main.cpp)
target_link_libraries(softwall_test_support PUBLIC softwall_solver GTest::gtest)
if(TARGET softwall_solver_single)
  add_library(softwall_test_support_single STATIC ${CMAKE_CURRENT_LIST_DIR}/mpi_main.cpp)
  target_link_libraries(softwall_test_support_single PUBLIC softwall_solver_single GTest::gtest)
endif()

function(softwall_add_mpi_test)
  cmake_parse_arguments(TEST "SINGLE" "NAME" "SOURCES;RANKS;SANITIZED" ${ARGN})
  if(NOT TEST_SANITIZED)
    set(TEST_SANITIZED 1)
  endif()
  add_executable(${TEST_NAME} ${TEST_SOURCES})
  target_link_libraries(${TEST_NAME} PRIVATE softwall_test_support$<$<BOOL:${TEST_SINGLE}>:_single>)
  foreach(ranks IN LISTS TEST_RANKS)
    set(test ${TEST_NAME}.ranks${ranks})
    add_test(NAME ${test} COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks}
                                  --oversubscribe $<TARGET_FILE:${TEST_NAME}>)
    set_tests_properties(${test} PROPERTIES PROCESSORS ${ranks} TIMEOUT 600
                                            ENVIRONMENT "${SOFTWALL_MPI_ENVIRONMENT}")
    if(NOT ranks IN_LIST TEST_SANITIZED)
      set_tests_properties(${test} PROPERTIES LABELS ranks)
    endif()
  endforeach()
endfunction()
