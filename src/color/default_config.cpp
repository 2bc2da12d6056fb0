// SPDX-License-Identifier: MIT
#include "color/default_config.h"

namespace shd::color {

// OpenColorIO has no built-in transform from linear Rec.709 to ACES, so that the config inverts the transform from AP1.
// sRGB: IEC 61966-2-1. Rec.709 display: ITU-R BT.1886 with black at 0. ACES: Academy SDR output transform 1.0.
const char kDefaultConfig[] = R"(ocio_profile_version: 2
environment: {}
search_path: ""
strictparsing: true
luma: [0.2126, 0.7152, 0.0722]
name: shd built-in
roles:
  aces_interchange: ACES2065-1
  cie_xyz_d65_interchange: CIE-XYZ-D65
  color_picking: sRGB - Texture
  data: Raw
  default: Linear Rec.709
  rendering: Linear Rec.709
  scene_linear: Linear Rec.709
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  sRGB:
    - !<View> {name: ACES 1.0 SDR-video, view_transform: ACES 1.0 SDR-video, display_colorspace: sRGB}
    - !<View> {name: Plain, view_transform: Plain, display_colorspace: sRGB}
    - !<View> {name: Raw, colorspace: Raw}
  Rec.709:
    - !<View> {name: ACES 1.0 SDR-video, view_transform: ACES 1.0 SDR-video, display_colorspace: Rec.709}
    - !<View> {name: Plain, view_transform: Plain, display_colorspace: Rec.709}
    - !<View> {name: Raw, colorspace: Raw}
active_displays: [sRGB, Rec.709]
active_views: [ACES 1.0 SDR-video, Plain, Raw]
inactive_colorspaces: [CIE-XYZ-D65]
default_view_transform: Plain
view_transforms:
  - !<ViewTransform>
    name: ACES 1.0 SDR-video
    from_scene_reference: !<BuiltinTransform> {style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0}
  - !<ViewTransform>
    name: Plain
    from_scene_reference: !<BuiltinTransform> {style: UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD}
display_colorspaces:
  - !<ColorSpace>
    name: CIE-XYZ-D65
    bitdepth: 32f
    isdata: false
  - !<ColorSpace>
    name: sRGB
    bitdepth: 32f
    isdata: false
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}
  - !<ColorSpace>
    name: Rec.709
    bitdepth: 32f
    isdata: false
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_REC.1886-REC.709}
colorspaces:
  - !<ColorSpace>
    name: ACES2065-1
    bitdepth: 32f
    isdata: false
  - !<ColorSpace>
    name: ACEScg
    bitdepth: 32f
    isdata: false
    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
  - !<ColorSpace>
    name: Linear Rec.709
    bitdepth: 32f
    isdata: false
    to_scene_reference: !<GroupTransform>
      children:
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD, direction: inverse}
        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
  - !<ColorSpace>
    name: sRGB - Texture
    bitdepth: 32f
    isdata: false
    to_scene_reference: !<GroupTransform>
      children:
        - !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055, style: mirror}
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD, direction: inverse}
        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
  - !<ColorSpace>
    name: Raw
    bitdepth: 32f
    isdata: true
)";

}  // namespace shd::color
