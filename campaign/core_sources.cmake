# Sources of the pure core: from a campaign file to what to do next. No processes, no disk but the file itself.
set(SOFTWALL_CORE_SOURCES
    case_mistakes.cpp
    estimate.cpp
    expand.cpp
    label.cpp
    parameters.cpp
    plan.cpp
    spec.cpp
    sweep.cpp)
