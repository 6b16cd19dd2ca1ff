# The pictures, in each format: of figures and maps. None is in `all`. Commands run in the folder of the sources.
file(RELATIVE_PATH build ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
set(formats svg pdf png)
file(GLOB style CONFIGURE_DEPENDS figures/paper/*.gp) # what pictures share
list(FILTER style EXCLUDE REGEX "/fig[0-9]+\\.gp$")
list(APPEND style ${PROJECT_SOURCE_DIR}/figures/draw.sh)

# Draws build/NAME.svg and so on by scripts below figures/, with settings of gnuplot, from files.
function(draw name settings scripts files)
  list(TRANSFORM scripts PREPEND figures/)
  list(TRANSFORM scripts PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE paths)
  foreach(format IN LISTS formats)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/${name}.${format}
      COMMAND figures/draw.sh ${build}/${name}.${format} "${settings}" ${scripts}
      DEPENDS ${files} ${paths} ${style}
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Drawing ${name}.${format}" VERBATIM)
  endforeach()
endfunction()

# ---- figures: a set of equations in its folder, and those of both sets above
file(GLOB scenes CONFIGURE_DEPENDS figures/paper/fig[0-9][0-9].toml)
foreach(scene IN LISTS scenes)
  get_filename_component(figure ${scene} NAME_WE)
  set(all_data "")
  set(all_settings "")
  set(inputs "")
  if(figure MATCHES "fig1[34]")
    set(inputs ${PROJECT_SOURCE_DIR}/reference-data/printed-inputs.csv ${PROJECT_SOURCE_DIR}/reference-data/ensembles.csv)
  endif()
  foreach(set published corrected)
    set(data ${PROJECT_BINARY_DIR}/figures/${set}/${figure}.csv ${PROJECT_BINARY_DIR}/figures/${set}/${figure}.var)
    set(settings "data_${set} = '${build}/figures/${set}/${figure}.csv';")
    draw(figures/${set}/${figure} "${settings}" paper/${figure}.gp "${data};${inputs}")
    list(APPEND data_${set} ${data})
    list(APPEND all_data ${data})
    string(APPEND all_settings "${settings}")
  endforeach()
  draw(figures/${figure} "${all_settings}" paper/${figure}.gp "${all_data};${inputs}")
  foreach(format IN LISTS formats)
    foreach(place "" published/ corrected/)
      list(APPEND drawn ${PROJECT_BINARY_DIR}/figures/${place}${figure}.${format})
    endforeach()
  endforeach()
  list(APPEND figures_of_page ${PROJECT_BINARY_DIR}/figures/${figure}.svg)
endforeach()
# Computed each time, so that damaged data are replaced.
foreach(set published corrected)
  add_custom_target(${set}-data BYPRODUCTS ${data_${set}}
    COMMAND figures/make/data.sh $<TARGET_FILE:rotor> ${set} ${build}/figures/${set}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Re-checking data: ${set}" VERBATIM)
endforeach()
add_custom_target(figure-pictures DEPENDS ${drawn})

# ---- maps: with 400 points along each axis in build/maps, and with as many as the name of each folder there says
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/maps/60) # the page's
file(GLOB maps CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/figures/maps figures/maps/*.toml)
list(TRANSFORM maps REPLACE "\\.toml$" "")
file(GLOB coarse CONFIGURE_DEPENDS LIST_DIRECTORIES true RELATIVE ${PROJECT_BINARY_DIR}/maps
  ${PROJECT_BINARY_DIR}/maps/[1-9]*)
set(numbers_of_points 400 ${coarse})
list(REMOVE_DUPLICATES numbers_of_points)
foreach(points IN LISTS numbers_of_points)
  set(folder maps/${points})
  if(points EQUAL 400)
    set(folder maps)
  endif()
  math(EXPR tenth "${points} / 10") # for a map with an ensemble at each point, but at least ten
  if(tenth LESS 10)
    set(tenth 10)
  endif()
  set(pictures "")
  foreach(map IN LISTS maps)
    set(name ${folder}/${map})
    set(made ${PROJECT_BINARY_DIR}/${name})
    set(sweep ${PROJECT_SOURCE_DIR}/figures/maps/${map}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sweep})
    file(READ ${sweep} text)
    string(REPLACE "points = 40\n" "points = ${tenth}\n" text "${text}")
    string(REPLACE "points = 400\n" "points = ${points}\n" text "${text}")
    file(GENERATE OUTPUT ${made}.toml CONTENT "${text}") # written only if it differs
    add_custom_command(OUTPUT ${made}.csv # an interrupted sweep resumes
      COMMAND rotor sweep ${build}/${name}.toml --force --out ${build}/${name}.csv
      DEPENDS rotor ${made}.toml
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Computing ${name}.csv" USES_TERMINAL VERBATIM)
    add_custom_command(OUTPUT ${made}-tolerance.txt
      COMMAND figures/maps/tolerance.sh ${build} figures/maps/${map}.toml ${build}/${folder}
        > ${build}/${name}-tolerance.txt
      DEPENDS rotor map-statistics ${sweep} ${PROJECT_SOURCE_DIR}/figures/maps/tolerance.sh
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Computing ${name}-tolerance.txt" USES_TERMINAL VERBATIM)
    if(map STREQUAL partial-rub) # over one quantity, as rotor plot draws it
      foreach(format IN LISTS formats)
        add_custom_command(OUTPUT ${made}.${format}
          COMMAND rotor plot ${build}/${name}.csv --out ${build}/${name}.${format}
          DEPENDS rotor ${made}.csv ${PROJECT_SOURCE_DIR}/figures/program/sweep.gp ${style}
          WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Drawing ${name}.${format}" VERBATIM)
      endforeach()
      list(APPEND pictures ${made})
      continue()
    endif()
    if(map STREQUAL rounding)
      add_custom_command(OUTPUT ${made}-shares.csv
        COMMAND map-statistics shares ${build}/${name}.toml ${build}/${name}.csv > ${build}/${name}-shares.csv
        DEPENDS map-statistics ${made}.toml ${made}.csv
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Computing ${name}-shares.csv" VERBATIM)
      draw(${name} "data = '${build}/${name}-shares.csv'; note = '${build}/${name}-tolerance.txt'"
        maps/rounding.gp "${made}-shares.csv;${made}-tolerance.txt")
      list(APPEND pictures ${made})
      continue()
    endif()
    add_custom_command(OUTPUT ${made}-theory.csv
      COMMAND map-theory ${build}/${name}.toml ${build}/${name}.csv > ${build}/${name}-theory.csv
      DEPENDS map-theory ${made}.toml ${made}.csv
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Computing ${name}-theory.csv" VERBATIM)
    set(column_outcome outcome)
    set(column_force peak_force_to_rolling_N)
    set(scripts maps/map.gp maps/lines.gp)
    if(EXISTS ${PROJECT_SOURCE_DIR}/figures/maps/${map}.gp)
      list(PREPEND scripts maps/${map}.gp)
    endif()
    foreach(shows outcome force) # as rotor plot draws it, with what that cannot know
      set(drafts ${build}/${name}-${shows})
      add_custom_command(OUTPUT ${made}-${shows}/settings.gp
        COMMAND ${CMAKE_COMMAND} -E make_directory ${drafts}
        COMMAND rotor plot ${build}/${name}.csv --columns ${column_${shows}} --drafts ${drafts}
        DEPENDS rotor ${made}.csv
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Computing ${drafts}" VERBATIM)
      draw(${name}-${shows} "folder = '${drafts}'; load folder.'/settings.gp'; \
theory = '${build}/${name}-theory.csv'; note = '${build}/${name}-tolerance.txt'" "${scripts}"
        "${made}-${shows}/settings.gp;${made}-theory.csv;${made}-tolerance.txt")
      list(APPEND pictures ${made}-${shows})
    endforeach()
  endforeach()
  if(points EQUAL 60)
    set(map_of_page ${PROJECT_BINARY_DIR}/${folder}/speed-friction-theory.csv)
  endif()
  foreach(format IN LISTS formats)
    list(TRANSFORM pictures APPEND .${format} OUTPUT_VARIABLE of_format)
    add_custom_target(maps-${points}-${format} DEPENDS ${of_format})
  endforeach()
endforeach()
