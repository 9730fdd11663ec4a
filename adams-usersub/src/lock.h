/* A lock for the few lines that write what all threads read. */
#ifndef LOCK_H
#define LOCK_H

#if defined(_MSC_VER)
#include <intrin.h>
static __inline void lock(volatile long *l) { while (_InterlockedExchange(l, 1)) {} }
static __inline void unlock(volatile long *l) { _InterlockedExchange(l, 0); }
#else
static inline void lock(volatile long *l) { while (__sync_lock_test_and_set(l, 1)) {} }
static inline void unlock(volatile long *l) { __sync_lock_release(l); }
#endif

#endif
