/* contdyn: CD_API, which stands before every function. It may be defined before, to declare them otherwise.
 *
 * On Windows:
 *   - CD_STATIC must be defined where a program links the archive and not the DLL; CMake's target
 *     contdyn::contdyn_static and pkg-config --static do so.
 *   - CD_EXPORT must be defined where the sources are compiled into a DLL whose functions no .def file lists.
 *   - Functions and callbacks have C's own calling convention, which is the compiler's default: a 32-bit program may not
 *     be compiled with /Gr, /Gz or -mrtd, none with /Gv. */
#ifndef CONTDYN_EXPORT_H
#define CONTDYN_EXPORT_H

#ifndef CD_API
#if defined(_WIN32) && defined(CD_EXPORT)
#define CD_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(CD_STATIC)
#define CD_API __declspec(dllimport)
#elif !defined(_WIN32) && defined(__GNUC__)
#define CD_API __attribute__((visibility("default")))
#else
#define CD_API
#endif
#endif

#endif
