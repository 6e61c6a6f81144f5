cmake_minimum_required(VERSION 3.25)
# cmake -DSOURCE_DIR=... -DOUTPUT=header.hpp -P git_revision.cmake: names the commit that is being built.
# "-modified" says that tracked files differ from it; "unknown" that this is no git checkout.
set(revision "unknown")
execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --short=12 HEAD
                OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
if(failed EQUAL 0)
  set(revision ${head})
  execute_process(COMMAND git -C ${SOURCE_DIR} diff --quiet HEAD -- RESULT_VARIABLE modified ERROR_QUIET)
  if(NOT modified EQUAL 0)
    string(APPEND revision "-modified")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
     "#pragma once\n\n#define SOFTWALL_GIT_REVISION \"${revision}\"\n")
