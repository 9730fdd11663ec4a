# find_package(dashpot) defines dashpot::dashpot, the shared library, and on systems other than Windows dashpot::static.
get_filename_component(_dashpot "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(NOT TARGET dashpot::dashpot)
    add_library(dashpot::dashpot SHARED IMPORTED)
    if(WIN32)
        set_target_properties(dashpot::dashpot PROPERTIES IMPORTED_LOCATION "${_dashpot}/bin/dashpot.dll")
        if(MSVC)
            set_target_properties(dashpot::dashpot PROPERTIES IMPORTED_IMPLIB "${_dashpot}/lib/dashpot.lib")
        else()
            set_target_properties(dashpot::dashpot PROPERTIES IMPORTED_IMPLIB "${_dashpot}/lib/libdashpot.dll.a")
        endif()
    else()
        # A library without a SONAME is linked by its path, which every program would then contain. This property links it as -ldashpot.
        set_target_properties(dashpot::dashpot PROPERTIES
            IMPORTED_LOCATION "${_dashpot}/lib/libdashpot.so"
            IMPORTED_NO_SONAME TRUE)
        add_library(dashpot::static STATIC IMPORTED)
        set_target_properties(dashpot::static PROPERTIES
            IMPORTED_LOCATION "${_dashpot}/lib/libdashpot.a"
            INTERFACE_INCLUDE_DIRECTORIES "${_dashpot}/include")
    endif()
    set_target_properties(dashpot::dashpot PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${_dashpot}/include")
endif()
unset(_dashpot)
