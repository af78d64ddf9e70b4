# Reads what the pages are made of into variables for page_assets.cpp.in.
set(MRPT_EXT_PAGE_MODULES run_data.js theme.js viewport.js map_layers.js map_view.js playback.js charts.js
                          time_charts.js category_charts.js main.js)
find_path(MRPT_EXT_DYGRAPHS_DIR dygraph.min.js PATHS /usr/share/javascript/dygraphs REQUIRED
          DOC "Folder of dygraph.min.js and dygraph.min.css (Debian: libjs-dygraphs)")

# The modules become one script, in which they see each other without imports.
set(MRPT_EXT_PAGE_SCRIPT "")
foreach(module IN LISTS MRPT_EXT_PAGE_MODULES)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS page/${module})
  file(READ page/${module} text)
  string(REGEX REPLACE "\nimport [^\n]*" "" text "\n${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  string(APPEND MRPT_EXT_PAGE_SCRIPT "${text}")
endforeach()

# A report names no address, not even in a comment; the licence of Dygraphs is in its Debian package.
file(READ ${MRPT_EXT_DYGRAPHS_DIR}/dygraph.min.js MRPT_EXT_CHART_LIBRARY)
string(REGEX REPLACE "https?://github.com/danvk/" "" MRPT_EXT_CHART_LIBRARY "${MRPT_EXT_CHART_LIBRARY}")
string(REGEX REPLACE "\n//# sourceMappingURL=[^\n]*" "" MRPT_EXT_CHART_LIBRARY "${MRPT_EXT_CHART_LIBRARY}")
file(READ ${MRPT_EXT_DYGRAPHS_DIR}/dygraph.min.css chart_style)
string(REGEX REPLACE "\n/[*]# sourceMappingURL=[^\n]*" "" chart_style "${chart_style}")

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS page/style.css page/playback.css page/playback.html
                                       page_assets.cpp.in)
file(READ page/style.css own_style)
file(READ page/playback.css playback_style)
set(MRPT_EXT_PAGE_STYLE "${chart_style}\n${own_style}${playback_style}")
file(READ page/playback.html MRPT_EXT_PLAYBACK_MARKUP)
