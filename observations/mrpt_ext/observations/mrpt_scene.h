#pragma once

#include "mrpt_ext/observations/mrpt_compatibility.h"

#ifdef MRPT_EXT_MRPT3
#include <mrpt/viz/CDisk.h>
#include <mrpt/viz/CEllipsoid2D.h>
#include <mrpt/viz/CGridPlaneXY.h>
#include <mrpt/viz/CSetOfLines.h>
#include <mrpt/viz/CSetOfObjects.h>
#include <mrpt/viz/CSphere.h>
#include <mrpt/viz/CText.h>
#include <mrpt/viz/Scene.h>
#include <mrpt/viz/stock_objects.h>
#else
#include <mrpt/opengl/CDisk.h>
#include <mrpt/opengl/CEllipsoid2D.h>
#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/opengl/CText.h>
#include <mrpt/opengl/stock_objects.h>
#endif

/// The 3-D scenes of MRPT, whose namespace and names MRPT 3 has changed.
namespace mrpt_ext
{
#ifdef MRPT_EXT_MRPT3
using MrptScene = scenes::Scene;
using MrptSceneObject = scenes::CVisualObject;
#else
using MrptScene = scenes::COpenGLScene;
using MrptSceneObject = scenes::CRenderizable;
#endif
}  // namespace mrpt_ext
