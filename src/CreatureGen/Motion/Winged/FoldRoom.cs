using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Winged;

/// <summary>The room that a standing body leaves to a folded wing, as the trunk sees it: its flank, the legs as they swing, by the capsules of their bones, the ground, and where its tail begins.</summary>
internal sealed class FoldRoom
{
    /// <summary>Girth of a tail where it begins, relative to that of the pelvis.</summary>
    private const float TailGirth = 0.6f;

    /// <summary>Girth of a body relative to the capsules of its bones, which a part of its skin is outside of: above and below what is seen of it from the side.</summary>
    private const float Girth = 1.12f;

    /// <summary>How far legs swing to either side of where they stand, radians.</summary>
    private const double LegSwing = 0.4;

    /// <summary>By which part of its height a leg stands out that swings about the vertical.</summary>
    private const float Sprawl = 0.5f;

    /// <summary>How far a wing keeps off the body, off the legs and off the midline, body lengths.</summary>
    private const double Gap = 0.015;
    private const double LegGap = 0.012;
    private const double MiddleGap = 0.006;

    /// <summary>How far the back of a four-legged body bends up at a gallop: rise over the square of the distance from the shoulder, body lengths.</summary>
    private const float Bend = 0.4f;

    /// <summary>How far wings may reach beyond where the tail begins, body lengths.</summary>
    private const double Overhang = 0.08;

    /// <summary>How far wings may reach to the side, body lengths.</summary>
    private const double Aside = 0.21;

    /// <summary>How high wings are to be above the ground, heights of the pelvis.</summary>
    private const double Clearance = 0.45;

    // What it costs to be in a leg, or beyond the tail's root, in relation to being off the body.
    private const double LegCost = 1500;
    private const double OverhangCost = 12;

    /// <summary>By how much boxes about rods are wider than they have to be, body lengths: more than single precision loses.</summary>
    private const double Slack = 1e-3;

    private readonly RodRow trunk;
    private readonly Rod[] legs;
    private readonly RodBox[] legBoxes;
    private readonly BoxGrid legGrid;
    private readonly Flank flank;
    private readonly float shoulder;
    private readonly float bend;
    private readonly double length;
    private readonly float tailBase;
    private readonly float tailEnd;
    private readonly Vector3 up;
    private readonly double floor;

    /// <summary>Takes a creature that stands in a posture.</summary>
    public FoldRoom(MotionSubject subject, StandingPosture posture, double bodyLength)
    {
        length = bodyLength;
        flank = new Flank(subject);
        (shoulder, bend) = Bending(subject, bodyLength);
        Skeleton skeleton = subject.Skeleton;
        Vector3 pelvis = skeleton.ModelPositions[Math.Max(skeleton.FirstOf(JointRole.Pelvis), 0)];

        // Seen from a raised trunk the legs and the ground are turned the other way.
        Quaternion lowered = AxisRotation.Pitch(posture.Raised);
        up = Rotation.Rotate(lowered, Vector3.UnitY);
        floor = Vec.Dot(up, pelvis) - pelvis.Y;
        Height = pelvis.Y;
        (tailBase, tailEnd) = Tail(subject, pelvis);
        LimbChain?[] limbs = LegBones(subject);
        var trunk = new List<Rod>();
        var legs = new List<Rod>();
        foreach (CapsuleCollider bone in subject.Bones)
        {
            Vector3 joint = skeleton.ModelPositions[bone.Joint];
            Quaternion rotation = skeleton.ModelRotations[bone.Joint];
            var rod = new Rod(joint + Rotation.Rotate(rotation, bone.Start), joint + Rotation.Rotate(rotation, bone.End), bone.Radius);
            if (limbs[bone.Joint] != null)
            {
                Quaternion standing = posture.Raised == 0f ? Quaternion.Identity : lowered;
                LimbChain leg = limbs[bone.Joint]!;
                Vector3 hip = skeleton.ModelPositions[leg.Joints[1]];
                Vector3 reach = skeleton.ModelPositions[leg.Joints[leg.Joints.Count - 1]] - hip;
                for (int swing = -1; swing <= 1; swing++)
                {
                    // Legs that stand out to the side swing about the vertical.
                    Quaternion turn = reach.X > -Sprawl * reach.Y ? AxisRotation.Yaw(swing * LegSwing) : AxisRotation.Pitch(swing * LegSwing);
                    legs.Add(rod.Turned(hip, turn).Turned(pelvis, standing));
                }
            }
            else if (skeleton.Joints[bone.Joint].Role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Neck or JointRole.Tail)
            {
                trunk.Add(rod with { Radius = Girth * rod.Radius });
            }
        }

        this.trunk = new RodRow(trunk, (float)(Slack * bodyLength));
        this.legs = legs.ToArray();
        legBoxes = Array.ConvertAll(this.legs, rod => rod.Box((float)((LegGap + Slack) * bodyLength)));
        legGrid = new BoxGrid(Array.ConvertAll(legBoxes, box => (box.Min, box.Max)));
    }

    /// <summary>Height of the pelvis, metres.</summary>
    private double Height { get; }

    /// <summary>What it costs a piece of a left wing to be somewhere, legs aside; 0 where it touches the body and nothing else.</summary>
    /// <param name="point">Where it is.</param>
    /// <param name="range">How its kind of wing folds.</param>
    /// <param name="clear">Share of the usual gap that it is to keep off the body: none where it grows out of it.</param>
    public double Cost(Vector3 point, FoldRange range, double clear)
    {
        double off = (Off(point) / length) - (clear * Gap);
        double cost = (off < 0 ? range.SunkCost : range.Closeness) * off * off;
        double across = Math.Max(0, MiddleGap - (point.X / length));
        double beyond = Math.Max(0, ((Scalar.Lerp(tailBase, tailEnd, range.Trailing) - point.Z) / length) - Overhang);
        double aside = range.AsideCost > 0 ? Math.Max(0, (point.X / length) - Aside) : 0;
        double low = Math.Max(0, ((Clearance * Height) - (Vec.Dot(up, point) - floor)) / length);
        double proud = range.ProudCost > 0 ? Math.Max(0, (point.Y - flank.Back(point.Z)) / length) : 0;
        return cost + (range.ProudCost * proud * proud) + (range.MiddleCost * across * across) + (range.AsideCost * aside * aside) + (OverhangCost * beyond * beyond) + (range.LowCost * low * low);
    }

    /// <summary>Lays a triangle of a left wing onto the flank: what is folded later lies outside of it.</summary>
    public void Cover(Vector3 a, Vector3 b, Vector3 c) => flank.Draw(a, b, c);

    /// <summary>What it costs a piece of a left wing to be in a leg or, for wings that lie over them, below one.</summary>
    /// <param name="point">Where it is.</param>
    /// <param name="range">How its kind of wing folds.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double CostOfLegs(Vector3 point, FoldRange range)
    {
        double leg = 0;
        foreach (int i in legGrid.At(point))
        {
            // Legs are far from most of a wing: what is outside of its box, a leg costs nothing. Without boxes a flier's profile takes three times as long, without their grid twice as long.
            if (legBoxes[i].MayHold(point, range.AboveLegs))
            {
                leg = Math.Max(leg, LegGap - ((range.AboveLegs ? legs[i].Above(point) : legs[i].Distance(point)) / length));
            }
        }

        return LegCost * leg * leg;
    }

    /// <summary>How far a point is off the body, as it stands and with its rump up: by its skin where that is seen from the side, elsewhere by its bones.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double Off(Vector3 point)
    {
        float behind = Math.Max(0f, shoulder - point.Z);
        float rise = bend * behind * behind;
        bool standing = flank.TryDistance(point, out double distance);
        (bool bent, double bentDistance) = (standing, distance);
        if (rise > 0f)
        {
            bent = flank.TryDistance(point - new Vector3(0f, rise, 0f), out bentDistance);
        }

        if (standing || bent)
        {
            return !bent ? distance : standing ? Math.Min(distance, bentDistance) : bentDistance;
        }

        return Math.Max(0, trunk.Distance(point));
    }

    /// <summary>Where the wings are, and how much the back behind them bends at a gallop: by how much it rises over the square of the distance, 1/metres.</summary>
    private static (float Shoulder, float Bend) Bending(MotionSubject subject, double bodyLength)
    {
        int legs = 0;
        float shoulder = 0f;
        foreach (LimbChain limb in subject.Limbs)
        {
            legs += limb.Kind == LimbKind.Leg && limb.Stands ? 1 : 0;
            shoulder = limb.Kind == LimbKind.Wing ? subject.Skeleton.ModelPositions[limb.Joints[0]].Z : shoulder;
        }

        return (shoulder, legs > 2 && Gallops(subject.Plan) ? Bend / (float)bodyLength : 0f);
    }

    /// <summary>Whether a body on four legs and more bends its back as it goes fast.</summary>
    private static bool Gallops(BodyPlan plan) => plan is not (BodyPlan.Buzzing or BodyPlan.Sprawling or BodyPlan.Columnar or BodyPlan.Hexapod or BodyPlan.ManyLegged);

    /// <summary>Where the tail begins, and where it ends.</summary>
    private static (float Base, float End) Tail(MotionSubject subject, Vector3 pelvis)
    {
        Skeleton skeleton = subject.Skeleton;
        float girth = 0f;
        float thick = float.MaxValue;
        float found = pelvis.Z;
        float end = pelvis.Z;
        foreach (CapsuleCollider bone in subject.Bones)
        {
            JointRole role = skeleton.Joints[bone.Joint].Role;
            girth = role == JointRole.Pelvis ? bone.Radius : girth;
            if (role == JointRole.Tail)
            {
                found = thick > TailGirth * girth ? skeleton.ModelPositions[bone.Joint].Z : found;
                thick = Math.Min(thick, bone.Radius);
                end = Math.Min(end, skeleton.ModelPositions[bone.Joint].Z + Rotation.Rotate(skeleton.ModelRotations[bone.Joint], bone.End).Z);
            }
        }

        return (found, end);
    }

    /// <summary>The left leg that each joint from the hip down belongs to.</summary>
    private static LimbChain?[] LegBones(MotionSubject subject)
    {
        var bones = new LimbChain?[subject.Skeleton.Count];
        foreach (LimbChain limb in subject.Limbs)
        {
            for (int k = 1; k < limb.Joints.Count && limb.Kind == LimbKind.Leg && limb.Side == Side.Left; k++)
            {
                bones[limb.Joints[k]] = limb;
            }
        }

        return bones;
    }
}
