using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Flying;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Slithering;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Skinning;

namespace CreatureGen.Benchmarks.Crowds;

/// <summary>One of a crowd: the stages of an animator's update one by one, in its order, and the matrices that a game needs after it.</summary>
internal sealed class Marcher
{
    private readonly MotionProfile profile;
    private readonly MotionInput input;
    private readonly Quaternion[] localRotations;
    private readonly Vector3[] localPositions;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;
    private readonly Matrix4x4[] matrices;
    private readonly EventQueue events;
    private readonly ILocomotionMode motion;
    private readonly HeadGaze? headGaze;
    private readonly SecondaryMotion secondary;
    private RootPlace root;

    public Marcher(MotionProfile profile, MotionInput input, RootPlace place)
    {
        this.profile = profile;
        this.input = input;
        int count = profile.Subject.Skeleton.Count;
        localRotations = new Quaternion[count];
        localPositions = new Vector3[count];
        modelRotations = new Quaternion[count];
        modelPositions = new Vector3[count];
        matrices = new Matrix4x4[count];
        events = new EventQueue(256);
        WalkingMode? legs = profile.Legs == null ? null : new WalkingMode(profile.Legs, profile.Gaits!, events);
        motion = profile.Flight != null ? new FlyingMode(profile.Flight, legs, events)
            : profile.Swim != null ? new SwimmingMode(profile.Swim)
            : profile.Slither != null ? new SlitheringMode(profile.Slither)
            : legs!;
        headGaze = profile.Gaze == null ? null : new HeadGaze(profile.Gaze, profile.Subject);
        secondary = new SecondaryMotion(profile.Swinging);
        root = place;
    }

    private Pose Local => new(localRotations, localPositions);

    private Pose Model => new(modelRotations, modelPositions);

    /// <summary>A stage of an update.</summary>
    public void Do(CrowdStage stage, float dt)
    {
        Skeleton skeleton = profile.Subject.Skeleton;
        switch (stage)
        {
            case CrowdStage.Rest:
                events.Clear();
                Local.SetToRest(skeleton);
                break;
            case CrowdStage.Motion:
                root = motion.Update(root, dt, input, MotionSettings.Default, FlatGround.Level, null, Local);
                break;
            case CrowdStage.Chain:
                ForwardKinematics.LocalToModel(skeleton, Local, Model);
                break;
            case CrowdStage.Gaze:
                headGaze?.Update(null, null, root, motion.Speed, 1f, dt, Local, Model);
                break;
            case CrowdStage.Springs:
                secondary.Update(root, motion.Clearance, motion.Incline, Vector3.Zero, dt, Local, Model);
                break;
            default:
                SkinMatrices.Fill(skeleton, Model, matrices);
                break;
        }
    }
}

/// <summary>The stages of an update.</summary>
internal enum CrowdStage
{
    /// <summary>The pose at rest.</summary>
    Rest,

    /// <summary>Legs, wings, fins or belly, and what goes with them.</summary>
    Motion,

    /// <summary>From the parents' space to model space.</summary>
    Chain,

    /// <summary>Head and eyes.</summary>
    Gaze,

    /// <summary>Tail, ears, feelers.</summary>
    Springs,

    /// <summary>Skin matrices.</summary>
    Skin,
}
