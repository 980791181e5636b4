"""The text of the compiled module: the joined core, and a function for Python for each of its kernels."""

from __future__ import annotations

from . import Joined

HEAD = """# cython: language_level=3, cdivision=True, binding=False, freethreading_compatible=True
# cython: emit_code_comments=False
from cpython.buffer cimport PyBUF_FULL_RO, PyBuffer_IsContiguous, PyBuffer_Release, PyObject_GetBuffer
from libc.math cimport {math}
from libc.string cimport memset

cdef inline long int_(double x) noexcept nogil: return <long> x
cdef inline long floor_(double x) noexcept nogil: return <long> floor(x)
cdef inline long ceil_(double x) noexcept nogil: return <long> ceil(x)
cdef inline double float_(double x) noexcept nogil: return x
cdef inline long floor_div_(long a, long b) noexcept nogil: return a // b - (a % b < 0)
cdef inline long min_int_(long a, long b) noexcept nogil: return b if b < a else a
cdef inline long max_int_(long a, long b) noexcept nogil: return b if b > a else a
cdef inline double min_float_(double a, double b) noexcept nogil: return b if b < a else a
cdef inline double max_float_(double a, double b) noexcept nogil: return b if b > a else a
"""
TAIL = '''
ctypedef void (*Kernel_)(double*, double*, long, long, double*, long) noexcept nogil

def probe(double one, double small, double near, double square, double seven, double least, double low,
          double high, double zero, double unknown):
    """Results that options of a C compiler change; `planar_pushing.core.keeps_bits` knows them."""
    return (
        (one + small) - one,  # a sum in another order
        near * near - square,  # a fused product
        seven / 3.0,  # a product with 1 / 3
        one * 0.1,  # a constant in single precision
        least * 2.0,  # a subnormal number that is read as zero
        low * 0.5,  # one that is written as zero
        high * high / high,  # a register with more digits
        zero + 0.0,  # a zero without a sign
        1.0 if unknown != unknown else 0.0,  # no test for NaN
    )

cdef int take_(numbers, Py_buffer* view, str name, long count, long width, bint written) except -1:
    """Hold the memory of an array that has the layout and the size that a kernel expects."""
    PyObject_GetBuffer(numbers, view, PyBUF_FULL_RO)
    if view.format != NULL and view.format[0] == b"d" and view.format[1] == 0:
        if PyBuffer_IsContiguous(view, b"C") and not (written and view.readonly):
            if count >= 0 and width >= 0 and (width == 0 or view.len // 8 // width >= count):
                return 0
    PyBuffer_Release(view)
    raise ValueError(f"{name}: contiguous numbers of type float64 expected, at least {count} times {width}")

cdef call_(Kernel_ kernel, data, rows, long count, long columns, results, long width):
    cdef Py_buffer data_view, rows_view, results_view
    take_(data, &data_view, "data", 0, 0, False)
    try:
        take_(rows, &rows_view, "rows", count, columns, False)
        try:
            take_(results, &results_view, "results", count, width, True)
            try:
                with nogil:
                    kernel(
                        <double*> data_view.buf, <double*> rows_view.buf, count, columns,
                        <double*> results_view.buf, width,
                    )
            finally:
                PyBuffer_Release(&results_view)
        finally:
            PyBuffer_Release(&rows_view)
    finally:
        PyBuffer_Release(&data_view)
'''
ENTRY = """
def {0}_(data, rows, long count, long columns, results, long width):
    call_({0}, data, rows, count, columns, results, width)
"""
# In C, so that they are text in the file.
MARKS = '''
cdef extern from *:
    """
    static const char digest_[] = "{0}";
    static const char recipe_[] = "{1}";
    """
    const char* digest_
    const char* recipe_

DIGEST = digest_[8:].decode("ascii")
RECIPE = recipe_[7:].decode("ascii")
'''


def text_of(joined: Joined) -> str:
    """The text of the module, without the marks by which it is known to be up to date."""
    entries = "".join(ENTRY.format(name) for name in joined.kernels)
    table = ", ".join(f'"{name}": {name}_' for name in joined.kernels)
    head = HEAD.format(math=", ".join(joined.math))
    return f"{head}{joined.source}{TAIL}{entries}\nKERNELS = {{{table}}}\n"
