"""NVIDIA's driver: memory on a GPU, kernels loaded from PTX, launches."""

from __future__ import annotations

import ctypes
import functools
import weakref
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.kernels.gpu.ptx import Kernel

#: Threads per block (measured on an H100: 32 to 128 are equally fast, more are slower).
BLOCK = 64


class GpuError(RuntimeError):
    """An error from the driver, in one line."""


@functools.cache
def _driver() -> Any:
    try:
        from cuda.bindings import driver
    except ImportError:
        raise InputError(
            "device gpu: needs cuda-bindings; in the checkout: pip install '.[gpu]'"
        ) from None
    return driver


def _call(name: str, *arguments: Any) -> Any:
    """Call the driver.

    Raises:
        GpuError: If it refuses.
    """
    driver = _driver()
    try:
        code, *values = getattr(driver, name)(*arguments)
    except RuntimeError as error:  # no driver library on this machine
        raise GpuError(str(error).strip().splitlines()[0]) from None
    if int(code):
        said = driver.cuGetErrorString(code)[1]
        text = said.decode() if isinstance(said, bytes) else f"error {int(code)}"
        raise GpuError(f"{name}: {text}")
    return values[0] if len(values) == 1 else tuple(values)


class Device(NamedTuple):
    """A GPU."""

    name: str
    memory: int
    """Total memory [bytes]."""
    processors: int
    context: Any


@functools.cache
def device() -> Device:
    """The first GPU.

    Raises:
        InputError: If there is no GPU, or no driver for it.
    """
    try:
        _call("cuInit", 0)
        if _call("cuDeviceGetCount") == 0:
            raise GpuError("no device")
        handle = _call("cuDeviceGet", 0)
        context = _call("cuDevicePrimaryCtxRetain", handle)
    except GpuError as error:
        raise InputError(f"device gpu: no NVIDIA GPU can be used here: {error}") from None
    name = _call("cuDeviceGetName", 128, handle)
    attribute = _driver().CUdevice_attribute.CU_DEVICE_ATTRIBUTE_MULTIPROCESSOR_COUNT
    return Device(
        name.split(b"\0")[0].decode(),
        int(_call("cuDeviceTotalMem", handle)),
        int(_call("cuDeviceGetAttribute", attribute, handle)),
        context,
    )


def _enter() -> None:
    """Make the context current: contexts belong to threads of the processor."""
    _call("cuCtxSetCurrent", device().context)


class Memory:
    """A copy of an array on the GPU, freed with this object."""

    def __init__(self, array: np.ndarray[Any, Any]) -> None:
        """Copy an array to the GPU."""
        _enter()
        self.shape, self.dtype, self.nbytes = array.shape, array.dtype, array.nbytes
        self.pointer = _call("cuMemAlloc", max(array.nbytes, 8))
        weakref.finalize(self, _free, int(self.pointer))
        self.fill(array)

    def fill(self, array: np.ndarray[Any, Any]) -> None:
        """Copy an array of the same size to the GPU."""
        _enter()
        solid = np.ascontiguousarray(array)
        if solid.nbytes:
            _call("cuMemcpyHtoD", self.pointer, solid.ctypes.data, solid.nbytes)

    def read_into(self, array: np.ndarray[Any, Any]) -> None:
        """Copy into an array of the same size, which must be contiguous."""
        self._read(array, 0)

    def row(self, number: int) -> np.ndarray[Any, Any]:
        """Copy of one row."""
        array = np.empty(self.shape[1:], self.dtype)
        self._read(array, number * array.nbytes)
        return array

    def _read(self, array: np.ndarray[Any, Any], offset: int) -> None:
        _enter()
        if array.nbytes:
            _call("cuMemcpyDtoH", array.ctypes.data, int(self.pointer) + offset, array.nbytes)


def _free(pointer: int) -> None:
    try:
        _enter()
        _call("cuMemFree", pointer)
    except (GpuError, InputError):
        pass  # the driver may be gone when the process ends


class LoadedKernel:
    """A kernel loaded on the GPU."""

    def __init__(self, kernel: Kernel, *, registers: int | None = None) -> None:
        """Assemble it with the driver.

        Args:
            kernel: The kernel as PTX.
            registers: Maximum per thread; by default the driver's choice.
        """
        _enter()
        driver = _driver()
        self._float = ctypes.c_float if kernel.precision == "single" else ctypes.c_double
        options: list[Any] = []
        values: list[Any] = []
        if registers is not None:
            options.append(driver.CUjit_option.CU_JIT_MAX_REGISTERS)
            values.append(registers)
        text = kernel.text.encode() + b"\0"
        self._module = _call("cuModuleLoadDataEx", text, len(options), options, values)
        self._function = _call("cuModuleGetFunction", self._module, kernel.name.encode())

    def attribute(self, name: str) -> int:
        """An attribute of the assembled kernel: ``NUM_REGS``, ``LOCAL_SIZE_BYTES``, ..."""
        _enter()
        which = getattr(_driver().CUfunction_attribute, f"CU_FUNC_ATTRIBUTE_{name}")
        return int(_call("cuFuncGetAttribute", which, self._function))

    def launch(self, flights: Memory, *arguments: Memory | int | float, block: int = BLOCK) -> None:
        """Run the kernel, and wait until it ends.

        Args:
            flights: Numbers of the flights, one for each thread.
            arguments: Of the entry point.
            block: Threads in a block.
        """
        _enter()
        (threads,) = flights.shape
        given = flights, threads, *arguments
        values = tuple(a.pointer if isinstance(a, Memory) else a for a in given)
        kinds = tuple(map(self._kind, given))
        grid = -(-threads // block)
        _call("cuLaunchKernel", self._function, grid, 1, 1, block, 1, 1, 0, 0, (values, kinds), 0)
        _call("cuCtxSynchronize")

    def _kind(self, argument: Any) -> Any:
        if isinstance(argument, Memory):
            return None  # the bindings recognise their own pointers
        return ctypes.c_int64 if isinstance(argument, int) else self._float
