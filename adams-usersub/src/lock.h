/* A spin lock for short sections that write data of all threads, and atomic access to a flag (load, store). */
#ifndef LOCK_H
#define LOCK_H

#if defined(_MSC_VER)
#include <intrin.h>
static __inline void lock(volatile long *l) { while (_InterlockedExchange(l, 1)) {} }
static __inline void unlock(volatile long *l) { _InterlockedExchange(l, 0); }
static __inline long load(volatile long *l) { return _InterlockedOr(l, 0); }
static __inline void store(volatile long *l, long value) { _InterlockedExchange(l, value); }
#else
static inline void lock(volatile long *l) { while (__atomic_exchange_n(l, 1, __ATOMIC_ACQUIRE)) {} }
static inline void unlock(volatile long *l) { __atomic_store_n(l, 0, __ATOMIC_RELEASE); }
static inline long load(volatile long *l) { return __atomic_load_n(l, __ATOMIC_ACQUIRE); }
static inline void store(volatile long *l, long value) { __atomic_store_n(l, value, __ATOMIC_RELEASE); }
#endif

#endif
