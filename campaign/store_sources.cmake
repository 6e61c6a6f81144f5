# Sources of the results store: the part of softwall_campaign that owns results.db.
include(${CMAKE_CURRENT_LIST_DIR}/embed_paper.cmake)

set(SOFTWALL_STORE_SOURCES
    ${SOFTWALL_PAPER_HEADER}
    backup.cpp
    file_system.cpp
    measured_cases.cpp
    paper_tables.cpp
    paper_values.cpp
    query.cpp
    result_table.cpp
    sqlite.cpp
    store.cpp
    store_documentation.cpp
    store_file.cpp
    store_read.cpp
    store_results.cpp
    store_schema.cpp
    store_words.cpp
    text_width.cpp)
