// SPDX-License-Identifier: MIT
//! Parts that the generated declarations share.

/// The default of a struct: by the library for a sized struct, else zero.
macro_rules! init {
    ($type:ident, $kind:ident) => {
        impl Default for $type {
            /// The defaults of the library.
            fn default() -> Self {
                let mut value = core::mem::MaybeUninit::<Self>::uninit();
                let pointer = value.as_mut_ptr().cast::<c_void>();
                // The call writes every byte of the struct.
                let result = unsafe { shd_desc_init($kind, pointer, core::mem::size_of::<Self>()) };
                assert_eq!(result, SHD_OK, "libshd has no {}", stringify!($type));
                unsafe { value.assume_init() }
            }
        }
    };
    ($type:ident) => {
        impl Default for $type {
            /// Zero in every field.
            fn default() -> Self {
                // Every field is an integer, a float, or a pointer that may be null.
                unsafe { core::mem::zeroed() }
            }
        }
    };
}

/// Debug output of an enum: the name of a value, or its number.
macro_rules! names {
    ($type:ident: $($name:ident),*) => {
        impl core::fmt::Debug for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                $(if *self == Self::$name {
                    return f.write_str(stringify!($name));
                })*
                write!(f, "{}({})", stringify!($type), self.0)
            }
        }
    };
}

/// Operators of an enum whose values are bits.
macro_rules! flags {
    ($type:ident) => {
        impl core::fmt::Debug for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                write!(f, "{}({:#x})", stringify!($type), self.0)
            }
        }
        impl $type {
            /// Whether all bits of `other` are set.
            pub const fn contains(self, other: Self) -> bool {
                self.0 & other.0 == other.0
            }
        }
        impl core::ops::BitOr for $type {
            type Output = Self;
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }
        impl core::ops::BitOrAssign for $type {
            fn bitor_assign(&mut self, other: Self) {
                self.0 |= other.0;
            }
        }
        impl core::ops::BitAnd for $type {
            type Output = Self;
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }
    };
}
