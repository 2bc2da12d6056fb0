// SPDX-License-Identifier: MIT
#pragma once

#include "io/abi/request.h"

/// Loads of textures, one function for each kind of file. They throw Failure.
namespace shd::extension {

/// An image.
shd_result load_image_texture(shd_context* context, const Input& input, const LoadRequest& request,
                              shd_texture** out_texture);

/// KTX2 or DDS, as stored.
shd_result load_stored_texture(shd_context* context, const Input& input, LoadRequest request,
                               shd_texture** out_texture);

/// A file of voxels, by desc.raw.
shd_result load_raw_texture(shd_context* context, const Input& input, const LoadRequest& request,
                            shd_texture** out_texture);

/// Images as slices, by desc.stack.
shd_result load_stack_texture(shd_context* context, const LoadRequest& request, shd_texture** out_texture);

/// A grid of OpenVDB.
shd_result load_grid_texture(shd_context* context, const Input& input, LoadRequest request, shd_texture** out_texture);

/// The pixels of an image, or of an image of the base level of a KTX2 or DDS file, as request.options.parts selects.
io::Bitmap load_bitmap(shd_context* context, const Input& input, LoadRequest request);

/// Expands an image that is stored as in a texture to RGBA.
io::Bitmap expand_stored(shd_context* context, io::Bitmap&& stored, const LoadRequest& request);

/// Converts colour to linear light; numbers that are linear, and RGBA8_SRGB, stay as they are. Throws Failure for an
/// unknown colour space.
void make_linear(const io::Memory& memory, io::Bitmap* bitmap);

/// Makes levels 1 and up of an RGBA bitmap of one level as SHD_LOAD_ALPHA_WEIGHTED states, and fills invisible texels.
void weight_by_alpha(shd_context* context, bool levels, io::Bitmap* bitmap);

/// Multiplies r, g and b of the RGBA texels of a linear bitmap by alpha, as SHD_LOAD_PREMULTIPLY states.
void premultiply(const io::Memory& memory, io::Bitmap* bitmap);

/// The format of RGBA pixels with the numbers of a texture.
shd_format expanded_format(shd_format stored);

/// The desc of a KTX2 or DDS file with `image_count` layers or faces, without texels, levels and tables.
shd_texture_desc describe_stored(const shd_texture_file_info& info, uint32_t image_count, const shd_channel* swizzle,
                                 const float* fill);

/// Throws Failure unless request.options.formats has the format.
void require_format(const LoadRequest& request, shd_file_format format, const char* name);

}  // namespace shd::extension
