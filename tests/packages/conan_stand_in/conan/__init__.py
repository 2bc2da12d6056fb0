# SPDX-License-Identifier: MIT
"""A stand-in for Conan 2: the base class of recipes."""
import pathlib


class Settings:
    """Values by attribute; an unknown name is an error, as in Conan."""

    def __init__(self, **values):
        self.__dict__.update(values)

    def get_safe(self, name, default=None):
        return self.__dict__.get(name, default)


class Compiler(Settings):
    def __str__(self):
        return self.name


class Options:
    """The options of a recipe; values outside the declared ones are refused."""

    def __init__(self, declared, values):
        self.__dict__["declared"] = declared
        self.__dict__["values"] = {}
        for name, value in values.items():
            setattr(self, name, value)

    def __getattr__(self, name):
        if name not in self.values:
            raise AttributeError(f"option '{name}' doesn't exist")
        return self.values[name]

    def __setattr__(self, name, value):
        if name not in self.declared:
            raise AttributeError(f"option '{name}' doesn't exist")
        if value not in self.declared[name]:
            raise ValueError(f"'{value}' is not a valid 'options.{name}' value; possible: {self.declared[name]}")
        self.values[name] = value

    def rm_safe(self, name):
        self.values.pop(name, None)


class Component:
    def __init__(self):
        self.libs, self.requires, self.system_libs, self.properties = [], [], [], {}
        self.includedirs, self.libdirs, self.bindirs = ["include"], ["lib"], ["bin"]

    def set_property(self, name, value):
        self.properties[name] = value


class Components(dict):
    def __missing__(self, name):
        self[name] = Component()
        return self[name]


class CppInfo(Component):
    def __init__(self):
        super().__init__()
        self.components = Components()


class ConanFile:
    """Attributes that Conan sets before it calls the methods."""
    implements = ()

    def __init__(self, folder, version, options, settings, conan_data):
        self.version, self.settings, self.conan_data = version, settings, conan_data
        self.options = Options(self.options, {**self.default_options, **options})
        self.cpp_info, self.required = CppInfo(), []
        self.recipe_folder, self.base = pathlib.Path(folder), pathlib.Path(folder)
        self.package_folder = str(self.base / "package")
        self.source_folder = self.build_folder = self.generators_folder = None

    def requires(self, reference):
        self.required.append(reference)
