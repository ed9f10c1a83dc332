using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Limbs;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Rigging;

/// <summary>A creature of a body plan, grown and rigged: the first that the sampler draws for the plan.</summary>
internal sealed class RigSubject
{
    private static readonly ConcurrentDictionary<BodyPlan, Lazy<RigSubject>> subjects = new();

    private static readonly ConcurrentDictionary<BodyPlan, Lazy<RigSubject[]>> groups = new();

    private readonly Lazy<SkinWeights[]> weights;

    private RigSubject(CreatureBlueprint blueprint)
    {
        Input = InputOf(blueprint);
        Rig = CreatureRigger.Build(Input);
        weights = new Lazy<SkinWeights[]>(() => AnatomicalWeights.Solve(Input, Rig));
    }

    /// <summary>Every plan, as theory data.</summary>
    /// <summary>All plans; every third of them is always tried, from hoofed bodies to fish.</summary>
    public static IEnumerable<TheoryDataRow<BodyPlan>> Plans => Enum.GetValues<BodyPlan>().Select((plan, i) => new TheoryDataRow<BodyPlan>(plan) { Explicit = i % 3 == 0 ? null : true });

    public RigInput Input { get; }

    public Rig Rig { get; }

    public Skeleton Skeleton => Rig.Skeleton;

    /// <summary>Anatomical weights.</summary>
    public SkinWeights[] Weights => weights.Value;

    public static RigSubject Of(BodyPlan plan) => subjects.GetOrAdd(plan, p => new Lazy<RigSubject>(() => new RigSubject(BlueprintOf(p)))).Value;

    /// <summary>The first blueprint of a plan.</summary>
    public static CreatureBlueprint BlueprintOf(BodyPlan plan) => First(b => b.Plan == plan);

    /// <summary>The first six creatures of a plan.</summary>
    public static RigSubject[] Several(BodyPlan plan) => groups.GetOrAdd(plan, p => new Lazy<RigSubject[]>(() =>
        Enumerable.Range(0, 4000).Select(seed => BlueprintSampler.Sample((ulong)seed)).Where(b => b.Plan == p).Take(6).Select(b => new RigSubject(b)).ToArray())).Value;

    /// <summary>The first creature with a fin on the back that ends in a swept tip.</summary>
    public static RigSubject WithSharkFin() => new(First(b => b.Fins.Any(f => f.Place == FinPlace.Dorsal && f.Style == FinStyle.Shark)));

    /// <summary>What the assembler hands to the rigger, with an eye laid into the skin.</summary>
    public static RigInput InputOf(CreatureBlueprint blueprint)
    {
        GrownSurface grown = GrownSurface.Grow(blueprint);
        EyeBlueprint eye = blueprint.Head.Eyes;
        SurfacePoint skin = grown.Skin.At(eye.Ring, eye.Segment);
        var socket = new EyeSocket(skin.Position - (skin.Normal * (float)(eye.Sink * eye.Radius)), skin.Normal, (float)eye.Radius);
        return new RigInput(blueprint, grown.Skin, grown.Surface, grown.Adjacency, grown.Appendages, grown.Mouth, socket);
    }

    /// <summary>The joint of a name.</summary>
    public Joint Joint(string name)
    {
        int index = Skeleton.IndexOf(name);
        return index >= 0 ? Skeleton.Joints[index] : throw new InvalidOperationException($"there is no joint {name}");
    }

    /// <summary>The surface after joints were turned about their own axes, and its normals.</summary>
    public (Vector3[] Positions, Vector3[] Normals) Bend(SkinWeights[] skin, Vector3[] restNormals, Func<Joint, Quaternion?> turn)
    {
        Skeleton skeleton = Skeleton;
        var rotations = new Quaternion[skeleton.Count];
        var positions = new Vector3[skeleton.Count];
        var pose = new Pose(rotations, positions);
        pose.SetToRest(skeleton);
        for (int j = 0; j < skeleton.Count; j++)
        {
            Quaternion? q = turn(skeleton.Joints[j]);
            if (q.HasValue)
            {
                rotations[j] = CreatureGen.Maths.Rotation.Multiply(rotations[j], q.Value);
            }
        }

        ForwardKinematics.LocalToModel(skeleton, pose, pose);
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, pose, matrices);
        var moved = new Vector3[skin.Length];
        var normals = new Vector3[skin.Length];
        CpuSkinning.Skin(matrices, skin, Input.Surface.Positions, restNormals, moved, normals);
        return (moved, normals);
    }

    private static CreatureBlueprint First(Func<CreatureBlueprint, bool> wanted)
    {
        for (ulong seed = 0; seed < 2000; seed++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed);
            if (wanted(blueprint))
            {
                return blueprint;
            }
        }

        throw new InvalidOperationException("no seed below 2000 gives such a creature");
    }
}
