#pragma once

/// Compiles a function once per instruction set and chooses when the program starts: plain loops then use the widest
/// vectors of the processor they run on, while the binary runs on all of them. What such a function calls must be
/// inlined into it. Put it before a definition with external linkage or in an unnamed namespace.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define MRPT_EXT_VECTOR_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
/// The same for loops of about ten iterations: vectors of eight would leave a remainder that costs more than they save.
#define MRPT_EXT_SHORT_LOOP_CLONES __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define MRPT_EXT_VECTOR_CLONES
#define MRPT_EXT_SHORT_LOOP_CLONES
#endif

/// Before a loop: no iteration depends on what another one writes, so that it may be done in vectors.
#if defined(__GNUC__) && !defined(__clang__)
#define MRPT_EXT_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define MRPT_EXT_INDEPENDENT_ITERATIONS
#endif
