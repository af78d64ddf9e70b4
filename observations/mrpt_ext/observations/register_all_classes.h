#pragma once

namespace mrpt_ext
{
/// Makes our observation classes known to MRPT. Loading the library does so, too; but a program without a reference to
/// it would lose it at link time (--as-needed) and read no record: call this from every main and test.
void registerAllObservationClasses();
}  // namespace mrpt_ext
