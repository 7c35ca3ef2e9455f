"""Plain functions of Python, translated to one JavaScript module by walking their syntax tree.

`translate.translate` takes the functions that are wanted and brings along whatever they call.
Translated is what numerical code of scalars, named tuples and flat buffers needs; anything else is
refused with its file and line.
"""
