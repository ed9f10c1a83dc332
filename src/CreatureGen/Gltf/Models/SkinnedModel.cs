using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Gltf.Models;

/// <summary>A character that another program made, as a GLB file gives it: skeleton, skin and clips, in metres, with +Y up. Immutable.</summary>
/// <remarks>The rest pose of the skeleton is that of the file's nodes. Its skin may have been bound in another pose: <see cref="FillSkinMatrices"/> knows both.</remarks>
public sealed class SkinnedModel
{
    private readonly ModelSkin skin;

    internal SkinnedModel(ModelDocument document, ModelJoints joints, ModelSkin skin, IReadOnlyList<KeyedClip> clips, IReadOnlyList<ModelSpring> springs)
    {
        Document = document;
        Joints = joints;
        this.skin = skin;
        Clips = clips;
        Springs = springs;
    }

    /// <summary>The joints that its skins and springs name and all nodes above them, parents before children, without scale; what each is and on what side as names and tree tell (<see cref="Skeleton.Build"/>).</summary>
    public Skeleton Skeleton => Joints.Skeleton;

    /// <summary>All its skinned triangles, in the space in which they were bound.</summary>
    public SkinnedMesh Mesh => skin.Mesh;

    /// <summary>Its animations; joints that one does not move are in rest pose in it. It loops if its <c>extras.loop</c> says so, or where they say nothing, as in files of other programs, if its joints end as they begin.</summary>
    public IReadOnlyList<KeyedClip> Clips { get; }

    /// <summary>Chains that swing by themselves (<c>VRMC_springBone</c>), those that others hang on first; none in most files. Update them in this order, after the animation.</summary>
    public IReadOnlyList<ModelSpring> Springs { get; }

    /// <summary>Rotation of each joint where it was bound.</summary>
    public ReadOnlySpan<Quaternion> BindRotations => skin.BindRotations;

    /// <summary>Position of each joint where it was bound, metres.</summary>
    public ReadOnlySpan<Vector3> BindPositions => skin.BindPositions;

    /// <summary>The file that it came from.</summary>
    internal ModelDocument Document { get; }

    /// <summary>Which joint is which node.</summary>
    internal ModelJoints Joints { get; }

    /// <summary>Fills in one matrix per joint that carries the mesh from where it was bound to a pose. Nothing is allocated.</summary>
    /// <param name="model">The pose in model space.</param>
    /// <param name="matrices">Receives one matrix per joint, for row vectors.</param>
    /// <exception cref="ArgumentException">A span is not as long as the skeleton.</exception>
    public void FillSkinMatrices(in Pose model, Span<Matrix4x4> matrices) => SkinMatrices.Fill(BindRotations, BindPositions, model, matrices);

    /// <summary>The <see cref="Mesh"/> as it is in the rest pose of the <see cref="Skeleton"/>. Made anew each time.</summary>
    public SkinnedMesh RestMesh()
    {
        int count = Mesh.Positions.Length;
        var matrices = new Matrix4x4[Skeleton.Count];
        var positions = new Vector3[count];
        var normals = new Vector3[count];
        FillSkinMatrices(new Pose(Skeleton.ModelRotations.ToArray(), Skeleton.ModelPositions.ToArray()), matrices);
        CpuSkinning.Skin(matrices, Mesh.Weights, Mesh.Positions, Mesh.Normals, positions, normals);
        return new SkinnedMesh(positions, normals, Mesh.Weights.ToArray(), Mesh.Triangles.ToArray());
    }
}
