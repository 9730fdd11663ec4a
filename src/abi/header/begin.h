#ifndef DASHPOT_H
#define DASHPOT_H

#include <stddef.h>
#include <stdint.h>

#if defined(_MSC_VER)
#define DASHPOT_ALIGNED(n) __declspec(align(n))
#else
#define DASHPOT_ALIGNED(n) __attribute__((aligned(n)))
#endif

#ifdef __cplusplus
extern "C" {
#endif
