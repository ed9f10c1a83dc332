using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Subjects;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion;

/// <summary>A skeleton of another program that moves as grown creatures do: it walks, turns, climbs, looks about, acts, falls and gets up. Immutable, and shared by any number of animators.</summary>
/// <remarks>
/// <para>A body such as creatures grow stands in for it, with its joints where those of the skeleton are: give <see cref="Subject"/> to a <see cref="MotionProfile"/> and that to a <see cref="CreatureAnimator"/>, and after each
/// update bring its pose over by <see cref="FillPose"/>.</para>
/// <para>Parts are told by roles, or by what joints are called and how they hang on one another (<see cref="Skeleton.Build"/>). How far joints turn follows from what legs are built like, not from the limits of the skeleton. Arms
/// that are held out at rest hang. What has no part in a body (fingers, twist bones, hair) keeps its place on what carries it.</para>
/// </remarks>
public sealed class RiggedBody
{
    private readonly StandIn stand;
    private readonly Vector3[] rest;
    private readonly Quaternion[] inverses;
    private readonly bool[] carried;

    /// <summary>Finds the parts of a skeleton.</summary>
    /// <param name="skeleton">With a trunk and at least one pair of legs that stand, facing +Z, +Y up.</param>
    /// <param name="ground">Height of the ground under its feet at rest, in its model space; null for where the skin of its feet is lowest, or without a skin for just below their lowest joint.</param>
    /// <param name="mass">Kilograms; null for what flesh within such a skin, or around such bones, weighs.</param>
    /// <param name="unit">Metres in a unit of the skeleton's space: 0.01 for one in centimetres. Large bodies move slowly.</param>
    /// <param name="skin">Its skin in the rest pose of the skeleton, in the skeleton's space (<c>SkinnedModel.RestMesh</c>): of it are soles, belly and all that it sits and lies on. Null for guesses from the bones.</param>
    /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
    /// <exception cref="ArgumentException">It has no trunk or no pair of legs that stands, the ground is not below its hips, the mass or the unit is not a positive number, or the skin is not of the skeleton.</exception>
    public RiggedBody(Skeleton skeleton, float? ground = null, float? mass = null, float unit = 1f, SkinnedMesh? skin = null)
    {
        Skeleton = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        RequirePositive(mass ?? 1f, nameof(mass), "kilograms");
        RequirePositive(unit, nameof(unit), "metres");
        RestSkin? reach = skin is null ? null : new RestSkin(skeleton, skin);
        stand = new StandIn(skeleton, ground, unit, reach);
        rest = stand.Skeleton.ModelPositions.ToArray();
        inverses = Array.ConvertAll(stand.Skeleton.ModelRotations.ToArray(), Rotation.Inverse);
        carried = new bool[skeleton.Count];
        bool begun = false;
        for (int joint = 0; joint < carried.Length; joint++)
        {
            int follows = stand.Follows[joint];
            JointRole role = follows < 0 ? JointRole.Other : stand.Skeleton.Joints[follows].Role;
            carried[joint] = role == JointRole.Hip || (role == JointRole.Pelvis && !begun);
            begun |= role == JointRole.Pelvis;
        }

        Subject = new MotionSubject(stand, reach is null ? new StandInFlesh(stand.Skeleton, stand.Limbs, mass) : new StandInFlesh(stand.Skeleton, reach.Around(stand, RestOfStandIn()), mass));
    }

    /// <summary>The skeleton that is to move.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>The body that stands in for it.</summary>
    public MotionSubject Subject { get; }

    /// <summary>Height of the ground in the skeleton's model space: what an animator's root stands on is this far above the model's origin.</summary>
    public float Ground => stand.Ground;

    /// <summary>Metres in a unit of the skeleton's space.</summary>
    public float Unit => stand.Unit;

    /// <summary>Brings over a pose. Allocates nothing.</summary>
    /// <param name="moved">Of the stand-in in model space (<see cref="CreatureAnimator.ModelPose"/>).</param>
    /// <param name="local">Receives the skeleton's own pose in the parents' space.</param>
    /// <param name="model">Receives the same in its model space.</param>
    /// <exception cref="ArgumentException">A pose is not as long as its skeleton.</exception>
    public void FillPose(in Pose moved, in Pose local, in Pose model)
    {
        RequireLength(moved, rest.Length, nameof(moved));
        RequireLength(local, Skeleton.Count, nameof(local));
        RequireLength(model, Skeleton.Count, nameof(model));
        ReadOnlySpan<int> follows = stand.Follows;
        ReadOnlySpan<Quaternion> aligns = stand.Aligns;
        for (int joint = 0; joint < follows.Length; joint++)
        {
            int parent = Skeleton.Parents[joint];
            Quaternion above = parent < 0 ? Quaternion.Identity : model.Rotations[parent];
            Vector3 origin = parent < 0 ? Vector3.Zero : model.Positions[parent];
            int led = follows[joint];
            local.Rotations[joint] = Skeleton.LocalRotations[joint];
            local.Positions[joint] = Skeleton.LocalPositions[joint];
            if (led >= 0)
            {
                Quaternion turn = Rotation.Multiply(Rotation.Multiply(moved.Rotations[led], inverses[led]), aligns[joint]);
                local.Rotations[joint] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(above), Rotation.Multiply(turn, Skeleton.ModelRotations[joint])));
            }

            if (carried[joint])
            {
                Vector3 place = Skeleton.ModelPositions[joint] + ((moved.Positions[led] - rest[led]) / stand.Unit);
                local.Positions[joint] = Rotation.Rotate(Rotation.Inverse(above), place - origin);
            }

            model.Rotations[joint] = Rotation.Multiply(above, local.Rotations[joint]);
            model.Positions[joint] = origin + Rotation.Rotate(above, local.Positions[joint]);
        }
    }

    /// <summary>Brings over a clip that was baked of the <see cref="Subject"/> (<see cref="ClipBaker.RecipesOf"/>): the same frames and events, speed and way over the ground in the skeleton's units.</summary>
    /// <param name="clip">Of the stand-in.</param>
    /// <param name="name">Of the clip that is made, where another has the name of this one; null for the same.</param>
    /// <returns>A clip of the <see cref="Skeleton"/>.</returns>
    /// <exception cref="ArgumentNullException">There is no clip.</exception>
    /// <exception cref="ArgumentException">It is of another number of joints than the stand-in, or the name is no name of a clip.</exception>
    public Clip Bring(Clip clip, string? name = null)
    {
        _ = clip ?? throw new ArgumentNullException(nameof(clip));
        if (clip.Joints != rest.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} of {clip.Joints} joints; expected the {rest.Length} of the stand-in"), nameof(clip));
        }

        int count = Skeleton.Count;
        var rotations = new Quaternion[clip.Frames * count];
        var positions = new Vector3[clip.Frames * count];
        var moved = new Pose(new Quaternion[rest.Length], new Vector3[rest.Length]);
        var model = new Pose(new Quaternion[count], new Vector3[count]);
        for (int frame = 0; frame < clip.Frames; frame++)
        {
            clip.Sample(clip.TimeOf(frame), moved);
            ForwardKinematics.LocalToModel(stand.Skeleton, moved, moved);
            FillPose(moved, new Pose(rotations.AsSpan(frame * count, count), positions.AsSpan(frame * count, count)), model);
        }

        if (clip.End == ClipEnd.Loops)
        {
            rotations.AsSpan(0, count).CopyTo(rotations.AsSpan(rotations.Length - count));
            positions.AsSpan(0, count).CopyTo(positions.AsSpan(positions.Length - count));
        }

        var events = new List<ClipEvent>();
        foreach (ClipEvent one in clip.Events)
        {
            events.Add(new ClipEvent(one.Time, one.Name, NameOf(stand.Skeleton.IndexOf(one.Joint)), one.Strength));
        }

        ClipPlace[] path = new List<ClipPlace>(clip.Path).ConvertAll(place => place with { Position = place.Position / stand.Unit }).ToArray();
        return new Clip(name ?? clip.Name, clip.End, clip.Rate, clip.Speed / stand.Unit, count, rotations, positions).WithEvents(events).WithPath(path);
    }

    /// <summary>The skeleton's pose in model space where its stand-in is at rest: arms that are held out hang.</summary>
    private Pose RestOfStandIn()
    {
        var local = new Pose(new Quaternion[Skeleton.Count], new Vector3[Skeleton.Count]);
        var model = new Pose(new Quaternion[Skeleton.Count], new Vector3[Skeleton.Count]);
        FillPose(new Pose(stand.Skeleton.ModelRotations.ToArray(), stand.Skeleton.ModelPositions.ToArray()), local, model);
        return model;
    }

    /// <summary>The joint that follows one of the stand-in, or the nearest above that has a follower; empty if there is none.</summary>
    private string NameOf(int led)
    {
        for (int joint = led; joint >= 0; joint = stand.Skeleton.Parents[joint])
        {
            int follower = stand.Follows.IndexOf(joint);
            if (follower >= 0)
            {
                return Skeleton.Joints[follower].Name;
            }
        }

        return string.Empty;
    }

    private static void RequirePositive(float number, string name, string of)
    {
        if (!(number > 0f && number < float.PositiveInfinity))
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} {number}; expected a positive number of {of}"), name);
        }
    }

    private static void RequireLength(in Pose pose, int joints, string name)
    {
        if (pose.Rotations.Length != joints || pose.Positions.Length != joints)
        {
            throw new ArgumentException(FormattableString.Invariant($"a pose of {pose.Rotations.Length} rotations and {pose.Positions.Length} positions; expected {joints} of each"), name);
        }
    }
}
