#pragma once

namespace mrpt_ext
{
/// Makes every class of ours known to MRPT: the observations, and the map under its .ini name `landmarkMap2D`.
/// Call it from every main and test: a program without a reference to the libraries loses them at link time
/// (--as-needed), and then reads no record and builds no map.
void registerAllClasses();
}  // namespace mrpt_ext
