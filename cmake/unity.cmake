set(WAYWRIGHT_UNITY
    1
    CACHE STRING "How many sources of a folder to compile as one; more make a new build faster")

# waywright_unite(NAME VARIABLE): replaces the sources in the list VARIABLE by generated sources. Each includes up to
# WAYWRIGHT_UNITY sources of one folder, so the compiler reads their headers once. The names in the unnamed namespaces
# of a folder must differ. NAME is a name for the folder of the generated sources. (The property UNITY_BUILD of CMake
# leaves out sources with compile options of their own, and the library has such options.)
function(waywright_unite name variable)
  if(WAYWRIGHT_UNITY LESS 2)
    return()
  endif()
  set(folders "")
  foreach(source IN LISTS ${variable})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    list(APPEND folders ${folder})
    list(APPEND sources_of_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(united "")
  foreach(folder IN LISTS folders)
    list(LENGTH sources_of_${folder} left)
    set(number 1)
    while(left GREATER 0)
      # The rest of the sources in equal parts.
      math(EXPR parts "(${left} + ${WAYWRIGHT_UNITY} - 1) / ${WAYWRIGHT_UNITY}")
      math(EXPR count "(${left} + ${parts} - 1) / ${parts}")
      # For GCC, each source is a header here, and a class in a header should not use names of an unnamed namespace.
      string(CONCAT text "#if defined(__GNUC__) && !defined(__clang__)\n"
                    "#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"\n#endif\n")
      foreach(i RANGE 1 ${count})
        list(POP_FRONT sources_of_${folder} source)
        string(APPEND text "#include \"${source}\"\n")
      endforeach()
      set(file ${CMAKE_CURRENT_BINARY_DIR}/unity/${name}/${folder}_${number}.cpp)
      file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
      list(APPEND united ${file})
      math(EXPR left "${left} - ${count}")
      math(EXPR number "${number} + 1")
    endwhile()
  endforeach()
  set(${variable} ${united} PARENT_SCOPE)
endfunction()
