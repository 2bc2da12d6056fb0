// SPDX-License-Identifier: MIT
//! Meshes.
use std::ptr;
use std::sync::Arc;

use crate::error::check;
use crate::object::Object;
use crate::{sys, Column, Context, Error, MeshFlag, MeshInfo, NormalWeight, Result, ShapeDesc, Topology};

/// Vertex numbers of triangles.
#[derive(Clone, Copy, Debug, Default)]
pub enum Indices<'a> {
    /// 0, 1, 2 and so on.
    #[default]
    Sequence,
    U32(Column<'a, u32>),
    U16(Column<'a, u16>),
}

/// Vertices and triangles of a mesh, in columns of one length; copied.
///
/// ```
/// # use shd::{Column, Context, Indices, Mesh, MeshDesc};
/// let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
/// let indices = [0u32, 1, 2, 2, 1, 3];
/// let desc = MeshDesc { indices: Indices::U32((&indices).into()), ..MeshDesc::new(Column::split(&positions)) };
/// let mesh = Mesh::new(&Context::new()?, &desc)?;
/// assert_eq!(mesh.info()?.triangle_count, 2);
/// # Ok::<(), shd::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MeshDesc<'a> {
    /// x, y, z in object space.
    pub position: [Column<'a>; 3],
    /// x, y, z in object space, of any length; computed if absent.
    pub normal: Option<[Column<'a>; 3]>,
    /// Weights of computed normals.
    pub normal_weight: NormalWeight,
    pub flags: MeshFlag,
    /// x, y, z in object space, and handedness.
    pub tangent: Option<[Column<'a>; 4]>,
    /// u, v; 0 if absent.
    pub uv: Option<[Column<'a>; 2]>,
    /// u, v of a second set; 0 if absent.
    pub uv1: Option<[Column<'a>; 2]>,
    /// Columns for materials and programs.
    pub attributes: &'a [Option<Column<'a>>],
    pub topology: Topology,
    pub indices: Indices<'a>,
}

impl<'a> MeshDesc<'a> {
    /// A mesh of positions alone.
    pub fn new(position: [Column<'a>; 3]) -> Self {
        Self {
            position,
            normal: None,
            normal_weight: NormalWeight::default(),
            flags: MeshFlag::default(),
            tangent: None,
            uv: None,
            uv1: None,
            attributes: &[],
            topology: Topology::default(),
            indices: Indices::Sequence,
        }
    }

    fn to_raw(self, attributes: &[sys::shd_f32_in]) -> Result<sys::shd_mesh_desc> {
        let mut raw = sys::shd_mesh_desc::default();
        let count = self.position[0].len();
        raw.vertex_count = count;
        fill(&mut raw.position, "mesh.position", Some(&self.position), count)?;
        fill(&mut raw.normal, "mesh.normal", self.normal.as_ref().map(|c| &c[..]), count)?;
        fill(&mut raw.tangent, "mesh.tangent", self.tangent.as_ref().map(|c| &c[..]), count)?;
        fill(&mut raw.uv, "mesh.uv", self.uv.as_ref().map(|c| &c[..]), count)?;
        fill(&mut raw.uv1, "mesh.uv1", self.uv1.as_ref().map(|c| &c[..]), count)?;
        (raw.normal_weight, raw.flags, raw.topology) = (self.normal_weight, self.flags.0, self.topology);
        raw.attribute_count = attributes.len();
        raw.attributes = attributes.as_ptr();
        match self.indices {
            Indices::Sequence => {}
            Indices::U32(column) => {
                raw.indices = sys::shd_u32_in { data: column.data, stride: column.stride };
                raw.index_count = column.len();
            }
            Indices::U16(column) => {
                raw.indices16 = sys::shd_u16_in { data: column.data, stride: column.stride };
                raw.index_count = column.len();
            }
        }
        Ok(raw)
    }

    /// The attributes in the form of C.
    fn raw_attributes(&self) -> Result<Vec<sys::shd_f32_in>> {
        let count = self.position[0].len();
        let mut raw = vec![sys::shd_f32_in::default(); self.attributes.len()];
        for (place, column) in raw.iter_mut().zip(self.attributes) {
            if let Some(column) = column {
                fill(std::slice::from_mut(place), "mesh.attributes", Some(std::slice::from_ref(column)), count)?;
            }
        }
        Ok(raw)
    }
}

/// Points at columns, which must have `count` elements.
fn fill(raw: &mut [sys::shd_f32_in], name: &str, columns: Option<&[Column<'_>]>, count: usize) -> Result<()> {
    for (axis, (place, column)) in raw.iter_mut().zip(columns.unwrap_or(&[])).enumerate() {
        if column.len() != count {
            let found = column.len();
            return Err(Error::argument(format!("{name}[{axis}]: {found} elements, not {count} as mesh.position[0]")));
        }
        *place = sys::shd_f32_in { data: column.data, stride: column.stride };
    }
    Ok(())
}

/// Vertices and triangles in object space. A mesh never changes; a clone is another owner of the same mesh.
#[derive(Clone, Debug)]
pub struct Mesh(Arc<Object<sys::shd_mesh>>);

/// Copies of columns of a mesh, as rows.
type Read = unsafe extern "C" fn(*const sys::shd_mesh, *const sys::shd_f32_out) -> sys::shd_result;

impl Mesh {
    /// Makes a mesh of columns.
    pub fn new(context: &Context, desc: &MeshDesc<'_>) -> Result<Self> {
        let attributes = desc.raw_attributes()?;
        let raw = desc.to_raw(&attributes)?;
        let create = |out| unsafe { sys::shd_mesh_create(context.as_raw(), &raw, out) };
        Ok(Self(Arc::new(Object::create(context, sys::shd_mesh_release, create)?)))
    }

    /// Makes the mesh of a shape, such as a sphere or the teapot.
    pub fn shape(context: &Context, desc: &ShapeDesc, flags: MeshFlag) -> Result<Self> {
        let raw = desc.to_raw();
        let create = |out| unsafe { sys::shd_mesh_create_shape(context.as_raw(), &raw, flags.0, out) };
        Ok(Self(Arc::new(Object::create(context, sys::shd_mesh_release, create)?)))
    }

    #[cfg(feature = "scene")]
    pub(crate) fn of(object: Object<sys::shd_mesh>) -> Self {
        Self(Arc::new(object))
    }

    /// The handle of C, borrowed from this owner.
    #[inline]
    pub fn as_raw(&self) -> *mut sys::shd_mesh {
        self.0.raw()
    }

    /// Counts and bounds.
    pub fn info(&self) -> Result<MeshInfo> {
        let mut raw = sys::shd_mesh_info::default();
        check(unsafe { sys::shd_mesh_get_info(self.as_raw(), &mut raw) })?;
        Ok(MeshInfo::from_raw(&raw))
    }

    /// Positions in object space.
    pub fn positions(&self) -> Result<Vec<[f32; 3]>> {
        self.read(sys::shd_mesh_read_positions)
    }

    /// Unit normals, given or computed.
    pub fn normals(&self) -> Result<Vec<[f32; 3]>> {
        self.read(sys::shd_mesh_read_normals)
    }

    /// Tangents and handedness; 0 if the mesh has none.
    pub fn tangents(&self) -> Result<Vec<[f32; 4]>> {
        self.read(sys::shd_mesh_read_tangents)
    }

    /// Texture coordinates; 0 if the mesh has none.
    pub fn uv(&self) -> Result<Vec<[f32; 2]>> {
        self.read(sys::shd_mesh_read_uv)
    }

    /// Vertex numbers of separate triangles.
    pub fn indices(&self) -> Result<Vec<u32>> {
        let mut indices = vec![0u32; 3 * self.info()?.triangle_count];
        let column = sys::shd_u32_out { data: indices.as_mut_ptr(), stride: 0 };
        check(unsafe { sys::shd_mesh_read_indices(self.as_raw(), &column) })?;
        Ok(indices)
    }

    fn read<const N: usize>(&self, read: Read) -> Result<Vec<[f32; N]>> {
        let mut rows = vec![[0.0f32; N]; self.info()?.vertex_count];
        let first = rows.as_mut_ptr().cast::<f32>();
        let mut columns = [sys::shd_f32_out { data: ptr::null_mut(), stride: 0 }; N];
        if !rows.is_empty() {
            for (axis, column) in columns.iter_mut().enumerate() {
                *column =
                    sys::shd_f32_out { data: unsafe { first.add(axis) }, stride: std::mem::size_of::<[f32; N]>() };
            }
        }
        // The columns have the vertex count of the mesh, which never changes.
        check(unsafe { read(self.as_raw(), columns.as_ptr()) })?;
        Ok(rows)
    }
}
