# The paper's tables as a string constant, softwall::schemas::kRostiBrandt2017TablesCsv in
# campaign/tables/embedded_paper.hpp: `softwall table` needs no data file beside the program.
set(SOFTWALL_PAPER_SOURCE ${PROJECT_SOURCE_DIR}/analysis/data/rosti_brandt_2017_tables.csv)
set(SOFTWALL_PAPER_HEADER ${PROJECT_BINARY_DIR}/generated/campaign/tables/embedded_paper.hpp)
add_custom_command(
  OUTPUT ${SOFTWALL_PAPER_HEADER}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${SOFTWALL_PAPER_HEADER} -DSOURCES=${SOFTWALL_PAPER_SOURCE}
          -P ${PROJECT_SOURCE_DIR}/schemas/embed.cmake
  DEPENDS ${SOFTWALL_PAPER_SOURCE} ${PROJECT_SOURCE_DIR}/schemas/embed.cmake
  COMMENT "Embedding the paper's tables"
  VERBATIM)
