# SPDX-License-Identifier: MIT
"""Reads what a dynamic ELF file of a 64-bit little-endian machine needs, after "System V Application Binary Interface"
(2013) and "Linux Standard Base Core 5.0" (2015, symbol versions)."""
import struct

MACHINES = {62: "x86_64", 183: "aarch64"}
PT_LOAD, PT_DYNAMIC, PT_GNU_STACK = 1, 2, 0x6474e551
DT_NEEDED, DT_STRTAB, DT_STRSZ, DT_SONAME, DT_RPATH, DT_RUNPATH = 1, 5, 10, 14, 15, 29
DT_VERNEED, DT_VERNEEDNUM, DT_TEXTREL, DT_FLAGS, DF_TEXTREL = 0x6ffffffe, 0x6fffffff, 22, 30, 4


class Elf:
    """needed, soname, rpath (a list of folders), versions {(library, version)}, machine, problems (unusual flags)."""

    def __init__(self, data):
        self.data = bytes(data)
        if self.data[:6] != b"\x7fELF\2\1":
            raise ValueError("not an ELF file of a 64-bit little-endian machine")
        try:
            self._read()
        except (struct.error, OverflowError) as problem:
            raise ValueError(f"malformed ELF file: {problem}") from None

    def _read(self):
        machine, = struct.unpack_from("<H", self.data, 18)
        self.machine = MACHINES.get(machine, f"machine {machine}")
        table, = struct.unpack_from("<Q", self.data, 32)
        size, count = struct.unpack_from("<HH", self.data, 54)
        self.segments = [struct.unpack_from("<IIQQQQQQ", self.data, table + i * size) for i in range(count)]
        entries, self.problems = [], []
        for kind, flags, offset, _, _, length, _, _ in self.segments:
            if kind == PT_DYNAMIC and offset + length <= len(self.data):
                words = struct.unpack_from(f"<{length // 16 * 2}Q", self.data, offset)
                entries = list(zip(words[::2], words[1::2]))
            if kind == PT_GNU_STACK and flags & 1:
                self.problems.append("the stack is executable")
        if (0, 0) in entries:
            entries = entries[:entries.index((0, 0))]
        single = dict(entries)
        self.strings = self._offset(single[DT_STRTAB]) if DT_STRTAB in single else 0
        self.strings_size = single.get(DT_STRSZ, 0)
        self.needed = [self._text(value) for tag, value in entries if tag == DT_NEEDED]
        self.soname = self._text(single[DT_SONAME]) if DT_SONAME in single else None
        paths = [self._text(value) for tag, value in entries if tag in (DT_RPATH, DT_RUNPATH)]
        self.rpath = [folder for path in paths for folder in path.split(":")]
        if DT_TEXTREL in single or single.get(DT_FLAGS, 0) & DF_TEXTREL:
            self.problems.append("it has text relocations")
        self.versions = set(self._versions(single)) if DT_VERNEED in single else set()

    def _offset(self, address):
        """Place in the file of an address."""
        for kind, _, offset, start, _, length, _, _ in self.segments:
            if kind == PT_LOAD and start <= address < start + length:
                return offset + address - start
        raise ValueError(f"malformed ELF file: no segment has the address {address:#x}")

    def _text(self, place):
        start = self.strings + place
        end = self.data.find(b"\0", start, self.strings + self.strings_size)
        if place >= self.strings_size or end < 0:
            raise ValueError("malformed ELF file: a string lies outside the table")
        return self.data[start:end].decode("utf-8", "replace")

    def _versions(self, single):
        at = self._offset(single[DT_VERNEED])
        for _ in range(single.get(DT_VERNEEDNUM, 0)):
            _, count, file, first, following = struct.unpack_from("<HHIII", self.data, at)
            entry = at + first
            for _ in range(count):
                _, _, _, name, step = struct.unpack_from("<IHHII", self.data, entry)
                yield self._text(file), self._text(name)
                entry += step
            if not following:
                break
            at += following

    def renamed(self, names):
        """The bytes of the file with names of libraries replaced by names of equal length."""
        data = bytearray(self.data)
        for old, new in names.items():
            if len(old.encode()) != len(new.encode()):
                raise ValueError(f"{old} and {new} are not of equal length")
            pattern, start = b"\0" + old.encode() + b"\0", self.strings
            while True:
                start = data.find(pattern, start, self.strings + self.strings_size)
                if start < 0:
                    break
                data[start + 1:start + len(pattern) - 1] = new.encode()
        return bytes(data)
