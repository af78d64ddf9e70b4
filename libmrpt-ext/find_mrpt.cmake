# mrpt_ext_find_mrpt(REQUIRED|QUIET <library>...): libraries of MRPT 2.5 to 2.15 or of MRPT 3, in either case as the targets
# mrpt::<library> of MRPT 2. MRPT 3 has packages mrpt_<library> with targets mrpt::mrpt_<library>, and its 3-D scenes in
# `viz` where MRPT 2 has them in `opengl`. Where both are installed MRPT 2 is taken; choose MRPT 3 with
# -DCMAKE_DISABLE_FIND_PACKAGE_mrpt-obs=ON. Sets MRPT_EXT_MRPT_VERSION. Installed beside our package configuration and
# included there.
macro(mrpt_ext_find_mrpt _mode)
  find_package(mrpt-obs 2.5 QUIET)
  if(mrpt-obs_FOUND)
    set(MRPT_EXT_MRPT_VERSION ${mrpt-obs_VERSION})
    foreach(_library ${ARGN})
      find_package(mrpt-${_library} 2.5 ${_mode})
    endforeach()
  else()
    foreach(_library ${ARGN})
      string(REGEX REPLACE "^opengl$" "viz" _library_of_3 ${_library})
      find_package(mrpt_${_library_of_3} 3 ${_mode})
      if(mrpt_${_library_of_3}_FOUND AND NOT TARGET mrpt::${_library})
        add_library(mrpt::${_library} ALIAS mrpt::mrpt_${_library_of_3})
      endif()
    endforeach()
    set(MRPT_EXT_MRPT_VERSION ${mrpt_obs_VERSION})
  endif()
endmacro()
