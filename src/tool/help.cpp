// SPDX-License-Identifier: MIT
#include "tool/options.h"

const char* help_text() {
  return R"(shd-render: a picture of a 3D model, shaded on the CPU by shd.

  shd-render [options] [MODEL] -o OUT.png

MODEL is any file assimp reads (glTF, OBJ, Collada, PLY, STL, 3DS ...); without one, the Utah teapot.
Metallic-roughness materials are taken whole: base colour, metallic-roughness, normal, occlusion and emissive textures.
Textures are looked for as the model names them, then beside it, whatever the case of their letters.

Picture
  -o, --output FILE     .png, .tif: through the display transform; .exr: scene-linear (default out.png)
  --size WxH            pixels (default 960x640)
  --samples N           per pixel: 1, 2, 4, 8 or 16 (default 1)
  --sample-shading      shade every sample, instead of every pixel once
  --supersampling N     each pixel the average of N x N, 1..16 (default 1)
  --visibility V        depth, painter, newell (default depth)
  --background R,G,B    scene-linear, or one number for grey, or none = transparent (default none,
                        or the environment)
  --display NAME        display of the colour config (default sRGB)
  --view NAME           view of that display (default "ACES 1.0 SDR-video"; "Plain" = encoding alone)
  --no-color            no display transform: the sRGB curve alone, clamped
  --hash                print a hash of the picture, the same on every machine, and save it only if -o is given: FNV-1a
                        of 64 bits over the linear floats r, g, b, a of each pixel
  --dither              ordered dither of 8-bit colours
  --aov                 also save texture coordinates, normals and triangle numbers (.exr only)
  --aovs A,B,...        also save these: uv, normal, triangle, position, derivatives, barycentrics, level, draw,
                        overdraw, all (.exr only)

Camera
  --orbit AZ,EL[,DIST]  where the eye is, seen from the model's centre: degrees to the right of the front, degrees
                        up, radii of the model away (default 30,20 and far enough to see all of it)
  --fov DEGREES         vertical field of view (default 35)
  --camera N            camera number N of the file, from 0, instead of these
  --turntable N         N pictures once around, OUT-0001.png and on
  --animation N|NAME    pose of the file at a time of this animation, by its number from 0 or its name
  --time SECONDS        that time (default the first key)
  --frames N            N pictures from the first key to the last one, OUT-0001.png and on

Light
  --lights PRESET       studio, headlight, course (two points), file (those of the model), none (default studio, or
                        none when lights are given)
  --light X,Y,Z[:R,G,B] point light, in radii of the model around its centre; colour at one radius; repeatable
  --sun X,Y,Z[:R,G,B]   light from that direction; repeatable
  --spot X,Y,Z[:R,G,B]  spot light there, as --light, that shines at the centre; repeatable
  --cone INNER,OUTER    half angles of spots, degrees (default 15,25)
  --cookie FILE         light cookie of spots: a projected texture; "window" = built in
  --shadows FILTER      hard, pcf, variance, summed-area, pcss: of all lights but lamps and ambient (default none)
  --softness S          how wide summed-area filters, and how large lights are to pcss, in radii (default 0.05)
  --shadow-size N       texels a side of each map (default 1024)
  --occlusion RAYS      ambient light hidden by the model itself, at vertices, with so many rays each, 1..65536;
                        replaces the model's occlusion textures (default none)
  --occlusion-radius R  length of these rays, in radii (default unlimited)
  --lamps N             N small coloured lights around the model
  --environment FILE    light and background from all around, an image or a cube map; replaces the preset
  --environment-projection P  of that image: lat-long, mirror-ball, angular, octahedral, or cube, a strip or a cross of
                        six faces (default by its shape)
  --environment-turn A  that image turned about the vertical, degrees (default 0)
  --environment-blur R  roughness of its reflection that is the background, 0..1 (default 0 = sharp)
  --exposure EV         all lights but the ambient one times 2^EV (default 0)
  --ambient R,G,B       or one number for all three (default 0.15, with an environment 0)

Surface
  --model M             lambert, phong, blinn-phong, normalized, combined, ggx, gooch, toon, unlit, matcap, glass
                        (default ggx for metallic-roughness and environments, else blinn-phong)
  --show V              normal, uv, level, barycentrics, instead of the shaded model
  --frequency F         flat, gouraud, phong (default phong)
  --diffuse R,G,B       colour, instead of the model's
  --specular KS         strength of the highlight, instead of the model's
  --exponent P          its sharpness, instead of the model's
  --metallic M          of ggx, 0..1, instead of the model's
  --roughness R         of ggx, 0..1, instead of the model's
  --texture FILE        on everything, instead of the model's textures; "checker" = a built-in pattern, "none"
  --solid K             a solid texture on everything, instead: stripes, checker, perlin, value, simplex, worley,
                        marble, wood
  --solid-size S        of its cells, stripes or rings, in world units (default 0.5)
  --filter F            nearest, bilinear, trilinear, bicubic, nearest-mip, nearest-mip-linear,
                        bilinear-mip, ripmap, summed-area, anisotropic, ewa, stochastic, exact (default trilinear)
  --lod-bias B          added to the level of detail: below 0 sharper, above 0 smoother (default 0)
  --uv-scale S          textures S times as often
  --normal-map FILE     tangent-space normals on everything, instead of the model's
  --keep-roughness K    what its mip levels do about bumps that they lose: none, toksvig, lean (default none)

Shape
  --shape S             teapot, sphere, plane, box, torus, instead of a model
  --tessellation N      divisions of each of the teapot's 32 patches, of other shapes' sides (default 16)
  --floor               a floor under the model
  --any-folder          files that the model names may lie outside its folder
  --height FILE         heights 0..1 on everything, for the following
  --bump FORM           tilt normals by it: gradient, texel (default none)
  --bump-scale S        height 1 in world units; with texel, factor on differences (default 1)
  --parallax D          shift textures as if height 0 were D below the surface, in world units
  --displace D          move the surface itself by the height times D, in world units, finely tessellated
  --edge-length PX      of the triangles that are moved, pixels (default 4)
  --lines WIDTH         draw silhouettes, creases and borders so many pixels wide (default none)
  --wireframe WIDTH     the edges of all triangles so many pixels wide, instead of surfaces
  --crease DEGREES      how sharp an edge is a crease (default 60)

Volume
  --volume FILE         a volume instead of a model: .vdb; a pattern of images such as slice_%03d.tif; a TIFF or EXR
                        whose pages are the slices; or voxels without a format, for which --volume-size is needed
  --volume-size WxHxD   of a file of voxels
  --volume-format F     of its numbers: u8, u16, u32, i8, i16, i32, f16, f32; with be (u16be) the highest byte is first
                        (default u8)
  --volume-header N     bytes before its voxels, or rest = the voxels end the file (default 0)
  --volume-slices A,B   first and last number of a pattern (default 0,0)
  --volume-grid NAME    of a .vdb file (default the first one of float or double)
  --volume-spacing X,Y,Z  distances of voxels, except in .vdb (default 1,1,1)
  --volume-up AXIS      y: rows go down, slices away from the viewer; z: slices go up (default y)
  --volume-range A,B    densities from clear to opaque (default the smallest and the largest one)
  --volume-density F    factor of opacity (default 1)
                        A volume is lit, except fog of .vdb; --model unlit shows its colours, without light

Machine
  --threads N           workers (default one per core); the picture does not depend on it
  --simd T              best, baseline, scalar, sse2, ssse3, sse4, avx2, avx512, neon, wasm; neither on this
  --progress            report progress and the time left even when stderr is no terminal
  --stats               what was drawn and how long each stage took, on stderr
  --help, --version     this text; the version

Prints the name and size of every picture that it saves. Exit codes: 0 done, 1 failed, 2 wrong options, 3 the model,
the volume or --texture cannot be read, 4 the picture cannot be written. A texture of the model that cannot be read is
reported and its colour used instead. Lights and cameras of the file that are not used are reported, too.
Some damaged models make assimp end the whole process: run models you do not trust in a sandbox of your own.
)";
}
