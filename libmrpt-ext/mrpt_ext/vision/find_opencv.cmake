# The three OpenCV libraries that the vision front ends use, as the imported target mrpt_ext_opencv. Debian keeps
# OpenCV's own CMake files in libopencv-dev, which brings thirty packages more; these need libopencv-core-dev,
# libopencv-imgproc-dev and libopencv-imgcodecs-dev. Installed beside our package configuration and included there.
if(NOT TARGET mrpt_ext_opencv)
  find_path(MRPT_EXT_OPENCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
  set(_mrpt_ext_opencv_libraries)
  foreach(_module core imgproc imgcodecs)
    find_library(MRPT_EXT_OPENCV_${_module} opencv_${_module})
    if(NOT MRPT_EXT_OPENCV_${_module} OR NOT MRPT_EXT_OPENCV_INCLUDE_DIR)
      message(FATAL_ERROR "OpenCV's library ${_module} is not found, expected libopencv-${_module}-dev")
    endif()
    list(APPEND _mrpt_ext_opencv_libraries ${MRPT_EXT_OPENCV_${_module}})
  endforeach()
  add_library(mrpt_ext_opencv INTERFACE IMPORTED)
  set_target_properties(mrpt_ext_opencv PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${MRPT_EXT_OPENCV_INCLUDE_DIR}"
                                                   INTERFACE_LINK_LIBRARIES "${_mrpt_ext_opencv_libraries}")
endif()
