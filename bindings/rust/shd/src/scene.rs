// SPDX-License-Identifier: MIT
//! Model files: feature `scene`.
use std::borrow::Cow;
use std::error::Error as StdError;
use std::ffi::{c_void, CStr, CString};
use std::os::raw::c_char;
use std::panic::{self, AssertUnwindSafe};
use std::path::Path;
use std::ptr;
use std::sync::Arc;

use crate::error::{check, Panic};
use crate::io::{check_flags, path_of};
use crate::object::Object;
use crate::{
    sys, Camera, Context, Draw, DrawDesc, Error, Light, LoadDesc, Material, Mesh, Result, ResultCode, SamplerDesc,
    SceneDesc, SceneFlag, SceneInfo, SceneInstance, ScenePart, Texture,
};

/// What a closure that answers names returns: the bytes of a file, or `None` if there is no such file.
pub type Found<'a> = std::result::Result<Option<Cow<'a, [u8]>>, Box<dyn StdError + Send + Sync>>;
type FindFn<'a> = dyn FnMut(&str) -> Found<'a> + 'a;

/// The contents of a model file. A clone is another owner of the same scene; parts may be used longer than the scene.
///
/// ```
/// # use shd::*;
/// # let context = Context::new()?;
/// let model = b"mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// let scene = SceneLoader::new(SceneDesc::default())
///     .find(|name| Ok((name == "a.mtl").then(|| b"newmtl red\nKd 1 0 0\n"[..].into())))
///     .load_memory(&context, model, "a.obj")?;
/// let (meshes, materials, lights) = (scene.meshes()?, scene.materials()?, scene.lights()?);
/// let mut frame = Frame::new().camera(Camera::default());
/// for instance in scene.instances()? {
///     frame = frame.draw(instance.draw(&meshes, &materials));
/// }
/// for light in &lights {
///     frame = frame.light(light);
/// }
/// let mut framebuffer = Framebuffer::new(&context, &FramebufferDesc { width: 8, height: 8, ..Default::default() })?;
/// assert_eq!(frame.render(&context, &mut framebuffer)?.triangle_count, 1);
/// # Ok::<(), shd::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Scene(Arc<Object<sys::shd_scene>>);

impl Scene {
    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_scene {
        self.0.raw()
    }

    /// Counts and bounds.
    pub fn info(&self) -> Result<SceneInfo> {
        let mut raw = sys::shd_scene_info::default();
        check(unsafe { sys::shd_scene_get_info(self.as_raw(), &mut raw) })?;
        Ok(SceneInfo::from_raw(&raw))
    }

    /// The texts of C from 0 on until there is none.
    fn texts(&self, text: impl Fn(usize) -> *const c_char) -> Vec<String> {
        let pointers = (0..).map(text).take_while(|text| !text.is_null());
        // Texts live as long as the scene.
        pointers.map(|text| unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()).collect()
    }

    /// Parts of the file that were left out or changed.
    pub fn warnings(&self) -> Vec<String> {
        self.texts(|i| unsafe { sys::shd_scene_get_warning(self.as_raw(), i) })
    }

    /// Names of the parts of a kind.
    pub fn names(&self, part: ScenePart) -> Vec<String> {
        self.texts(|i| unsafe { sys::shd_scene_get_name(self.as_raw(), part, i) })
    }

    /// Parts that are objects, each as another owner.
    fn parts<T, P>(
        &self,
        count: usize,
        get: unsafe extern "C" fn(*const sys::shd_scene, usize) -> *mut T,
        retain: unsafe extern "C" fn(*mut T),
        release: unsafe extern "C" fn(*mut T),
        of: impl Fn(Object<T>) -> P,
    ) -> Vec<P> {
        let share = |i| Object::share(self.0.context(), unsafe { get(self.as_raw(), i) }, retain, release);
        (0..count).map(|i| of(share(i))).collect()
    }

    /// The meshes.
    pub fn meshes(&self) -> Result<Vec<Mesh>> {
        let (retain, release) = (sys::shd_mesh_retain, sys::shd_mesh_release);
        Ok(self.parts(self.info()?.mesh_count, sys::shd_scene_get_mesh, retain, release, Mesh::of))
    }

    /// The materials, at least one.
    pub fn materials(&self) -> Result<Vec<Material<'static>>> {
        let (retain, release) = (sys::shd_material_retain, sys::shd_material_release);
        Ok(self.parts(self.info()?.material_count, sys::shd_scene_get_material, retain, release, Material::of))
    }

    /// The textures that could be read.
    pub fn textures(&self) -> Result<Vec<Texture<'static>>> {
        let (retain, release) = (sys::shd_texture_retain, sys::shd_texture_release);
        Ok(self.parts(self.info()?.texture_count, sys::shd_scene_get_texture, retain, release, Texture::owned))
    }

    /// The lights.
    pub fn lights(&self) -> Result<Vec<Light<'static>>> {
        let (retain, release) = (sys::shd_light_retain, sys::shd_light_release);
        Ok(self.parts(self.info()?.light_count, sys::shd_scene_get_light, retain, release, Light::of))
    }

    /// The cameras.
    pub fn cameras(&self) -> Result<Vec<Camera>> {
        let camera = |i| {
            let mut raw = sys::shd_camera::default();
            check(unsafe { sys::shd_scene_get_camera(self.as_raw(), i, &mut raw) }).map(|()| Camera::from_raw(&raw))
        };
        (0..self.info()?.camera_count).map(camera).collect()
    }

    /// Meshes with materials, placed in the world.
    pub fn instances(&self) -> Result<Vec<SceneInstance>> {
        let instance = |i| {
            let mut raw = sys::shd_scene_instance::default();
            check(unsafe { sys::shd_scene_get_instance(self.as_raw(), i, &mut raw) })?;
            Ok(SceneInstance::from_raw(&raw))
        };
        (0..self.info()?.instance_count).map(instance).collect()
    }

    /// The first and the last key of an animation, in seconds.
    pub fn animation_times(&self, animation: usize) -> Result<(f64, f64)> {
        let (mut first, mut last) = (0.0, 0.0);
        check(unsafe { sys::shd_scene_get_animation_times(self.as_raw(), animation, &mut first, &mut last) })?;
        Ok((first, last))
    }

    /// A scene of the file at some second of an animation.
    pub fn pose(&self, animation: usize, seconds: f64) -> Result<Scene> {
        let create = |out| unsafe { sys::shd_scene_pose(self.as_raw(), animation, seconds, out) };
        Ok(Self(Arc::new(Object::create(self.0.context(), sys::shd_scene_release, create)?)))
    }
}

impl SceneInstance {
    /// The draw of an instance, with the meshes and materials of its scene.
    ///
    /// # Panics
    /// If they are not those of the scene, and have fewer elements.
    pub fn draw<'a>(&self, meshes: &'a [Mesh], materials: &'a [Material<'a>]) -> Draw<'a> {
        let desc = DrawDesc { object_to_world: self.object_to_world, cull: self.cull, ..Default::default() };
        Draw::new(&meshes[self.mesh], &materials[self.material]).desc(desc)
    }
}

/// Options of a load; see [`Scene`].
///
/// `SceneFlag::IN_PROCESS` and `LoadFlag::IN_PROCESS` are refused, because a hostile file could then break the safety of
/// the program.
pub struct SceneLoader<'a> {
    desc: SceneDesc,
    sampler: Option<SamplerDesc>,
    texture: Option<LoadDesc>,
    find: Option<Box<FindFn<'a>>>,
}

impl<'a> SceneLoader<'a> {
    /// Flags and budgets.
    pub fn new(desc: SceneDesc) -> Self {
        Self { desc, sampler: None, texture: None, find: None }
    }

    /// The sampler of all textures.
    pub fn sampler(mut self, sampler: SamplerDesc) -> Self {
        self.sampler = Some(sampler);
        self
    }

    /// Options of each texture file.
    pub fn texture(mut self, texture: LoadDesc) -> Self {
        self.texture = Some(texture);
        self
    }

    /// Answers the names of the model's files, in place of its folder. An error of the closure is the error of the load,
    /// and a panic continues in the load.
    pub fn find(mut self, find: impl FnMut(&str) -> Found<'a> + 'a) -> Self {
        self.find = Some(Box::new(find));
        self
    }

    /// Reads a model file.
    pub fn load(self, context: &Context, path: impl AsRef<Path>) -> Result<Scene> {
        let path = path_of(path.as_ref())?;
        self.run(context, |desc, out| unsafe { sys::shd_scene_load(context.as_raw(), path.as_ptr(), desc, out) })
    }

    /// Reads a model file in memory. `name` is that of the file, such as "model.obj", for formats without a mark of
    /// their own.
    pub fn load_memory(self, context: &Context, bytes: &[u8], name: &str) -> Result<Scene> {
        let name = CString::new(name).map_err(|_| Error::argument("name: it has a zero byte"))?;
        self.run(context, |desc, out| unsafe {
            let first = bytes.as_ptr().cast();
            sys::shd_scene_load_memory(context.as_raw(), first, bytes.len(), name.as_ptr(), desc, out)
        })
    }

    fn run(
        mut self,
        context: &Context,
        load: impl FnOnce(&sys::shd_scene_desc, *mut *mut sys::shd_scene) -> ResultCode,
    ) -> Result<Scene> {
        if self.desc.flags.contains(SceneFlag::IN_PROCESS) {
            return Err(Error::argument(
                "scene.flags: IN_PROCESS, which needs sys::shd_scene_load() and trusted files",
            ));
        }
        self.texture.as_ref().map_or(Ok(()), check_flags)?;
        let sampler = self.sampler.map(SamplerDesc::to_raw);
        let texture = self.texture.map(LoadDesc::to_raw);
        let mut desc = self.desc.to_raw();
        desc.sampler = sampler.as_ref().map_or(ptr::null(), |sampler| sampler);
        desc.texture = texture.as_ref().map_or(ptr::null(), |texture| texture);
        let mut call = self.find.take().map(|find| FindCall { find, answers: Vec::new(), failure: None });
        if let Some(call) = &mut call {
            desc.find = Some(find);
            desc.user_data = (call as *mut FindCall<'_>).cast();
        }
        let made = Object::create(context, sys::shd_scene_release, |out| load(&desc, out));
        match call.and_then(|call| call.failure) {
            Some(Failure::Panic(panic)) => panic::resume_unwind(panic),
            Some(Failure::Error(problem)) => Err(Error::new(ResultCode::ERROR_CALLBACK, problem)),
            None => Ok(Scene(Arc::new(made?))),
        }
    }
}

enum Failure {
    Error(String),
    Panic(Panic),
}

/// The closure of a load, and its answers, which live until the load ends.
struct FindCall<'a> {
    find: Box<FindFn<'a>>,
    answers: Vec<Cow<'a, [u8]>>,
    failure: Option<Failure>,
}

unsafe extern "C" fn find(
    name: *const c_char,
    out_bytes: *mut *const c_void,
    out_size: *mut usize,
    user_data: *mut c_void,
) -> ResultCode {
    // The library passes the user_data of run() on its thread, and a name for this call alone.
    let (call, name) = unsafe { (&mut *(user_data as *mut FindCall<'_>), CStr::from_ptr(name)) };
    let run = AssertUnwindSafe(|| (call.find)(&name.to_string_lossy()).map_err(|problem| problem.to_string()));
    call.failure = Some(match panic::catch_unwind(run) {
        Ok(Ok(None)) => return ResultCode::ERROR_NOT_FOUND,
        Ok(Ok(Some(bytes))) => {
            // The bytes stay where they are when their owner moves.
            unsafe { (*out_bytes, *out_size) = (bytes.as_ptr().cast(), bytes.len()) };
            call.answers.push(bytes);
            return ResultCode::OK;
        }
        Ok(Err(problem)) => Failure::Error(problem),
        Err(panic) => Failure::Panic(panic),
    });
    ResultCode::ERROR_CALLBACK
}
