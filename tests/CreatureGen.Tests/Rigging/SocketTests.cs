using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

/// <summary>Frames in which things are worn, held or ridden.</summary>
public sealed class SocketTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Every_creature_has_a_saddle_a_crown_a_mouth_and_the_tip_of_its_tail_on_its_skin(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Vector3[] skin = subject.Input.Surface.Positions;
        float edge = skin.Max(p => p.Z) - skin.Min(p => p.Z);
        foreach (SocketKind kind in new[] { SocketKind.Saddle, SocketKind.Head, SocketKind.Mouth, SocketKind.TailTip })
        {
            CreatureSocket socket = Assert.Single(subject.Rig.Sockets, s => s.Kind == kind);
            (Vector3 place, _, Vector3 y, Vector3 z) = Frame(subject.Rig, socket);
            Assert.Equal(Side.Median, socket.Side);
            Assert.Equal(0f, place.X, 1e-5f);
            Assert.True(skin.Min(p => Vector3.Distance(p, place)) < 0.06f * edge, $"{kind} is {skin.Min(p => Vector3.Distance(p, place))} m from the skin of a body of {edge} m");
            Vector3 outward = kind is SocketKind.Saddle or SocketKind.Head ? y : z;

            // A hollow back rises a little before and behind its saddle, to shoulder blades and haunches.
            Assert.True(Mean(skin, p => Vector3.Dot(p - place, outward), place, 0.15f * edge) < 0.02f * edge, $"{kind} looks into the body: {outward}");
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void From_the_mouth_over_crown_and_saddle_to_the_tail_is_the_way_from_front_to_back(BodyPlan plan)
    {
        foreach (RigSubject subject in RigSubject.Several(plan))
        {
            double[] arcs = new[] { SocketKind.Mouth, SocketKind.Head, SocketKind.Saddle, SocketKind.TailTip }
                .Select(kind => subject.Rig.Sockets.Single(s => s.Kind == kind))
                .Select(s => (double)subject.Rig.Spine.BoneOf(s.Joint)).ToArray();
            Assert.True(arcs[0] <= arcs[1] && arcs[1] < arcs[2] && arcs[2] < arcs[3], string.Join(" ", arcs));
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Each_arm_has_a_hand_and_the_right_ones_are_mirror_images(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        CreatureSocket[] hands = subject.Rig.Sockets.Where(s => s.Kind == SocketKind.Hand).ToArray();
        LimbChain[] arms = subject.Rig.Limbs.Where(l => l.Kind == LimbKind.Arm).ToArray();
        Assert.Equal(arms.Length, hands.Length);
        foreach (LimbChain arm in arms)
        {
            CreatureSocket hand = hands.Single(h => h.Joint == arm.Joints[^2]);
            (Vector3 place, Vector3 x, Vector3 y, Vector3 z) = Frame(subject.Rig, hand);
            Vector3 fingers = subject.Skeleton.ModelPositions[arm.Joints[^1]] - subject.Skeleton.ModelPositions[arm.Joints[^2]];
            Assert.True(Vector3.Dot(z, Vector3.Normalize(fingers)) > 0.9999f);
            if (arm.Side == Side.Left)
            {
                CreatureSocket other = hands.Single(h => h.Name == hand.Name.Replace("_L", "_R", StringComparison.Ordinal));
                (Vector3 there, Vector3 right, Vector3 up, Vector3 ahead) = Frame(subject.Rig, other);
                Near(Vec.Mirror(place), there);
                Near(-Vec.Mirror(x), right);
                Near(Vec.Mirror(y), up);
                Near(Vec.Mirror(z), ahead);
            }
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Points_on_the_spine_are_frames_out_of_the_skin_with_names_of_their_own(BodyPlan plan)
    {
        Rig rig = RigSubject.Of(plan).Rig;
        Assert.Equal(rig.Sockets.Count, rig.Sockets.Select(s => s.Name).Distinct().Count());
        foreach (AttachmentPoint point in rig.AttachmentPoints)
        {
            CreatureSocket socket = rig.Sockets.Single(s => s.Name == point.Name);
            (Vector3 place, Vector3 x, Vector3 y, Vector3 z) = Frame(rig, socket);
            Near(point.Position, place);
            Near(point.Normal, y);
            Near(Vector3.Cross(y, z), x);
            int bone = rig.Spine.BoneOf(point.Joint);
            Vector3 headward = rig.Line.At(rig.Line.RingAt(rig.Spine.Start(bone))) - rig.Line.At(rig.Line.RingAt(rig.Spine.End(bone)));
            Assert.True(Vector3.Dot(z, headward) > 0f, $"{point.Name}: +Z {z}, head {headward}");
        }
    }

    [Fact]
    public void On_a_level_back_the_saddle_is_in_its_middle()
    {
        double[] places = new[] { BodyPlan.Digitigrade, BodyPlan.Unguligrade, BodyPlan.Columnar, BodyPlan.Sprawling }.SelectMany(RigSubject.Several).Select(subject =>
        {
            float z = Frame(subject.Rig, subject.Rig.Sockets.Single(s => s.Kind == SocketKind.Saddle)).Place.Z;
            float chest = subject.Skeleton.ModelPositions[subject.Skeleton.IndexOf("Chest")].Z;
            float pelvis = subject.Skeleton.ModelPositions[subject.Skeleton.IndexOf("Pelvis")].Z;
            return (double)((chest - z) / (chest - pelvis));
        }).OrderBy(t => t).ToArray();
        Assert.InRange(places[places.Length / 2], 0.3, 0.7);
        Assert.InRange(places.Count(t => t is > 0.2 and < 0.8), 0.8 * places.Length, places.Length);
    }

    [Fact]
    public void Upright_creatures_of_many_seeds_have_hands()
    {
        RigSubject[] uprights = RigSubject.Several(BodyPlan.Upright);
        Assert.Contains(uprights, u => u.Rig.Sockets.Count(s => s.Kind == SocketKind.Hand) == 2);
    }

    [Fact]
    public void Sockets_of_a_creature_twice_as_large_are_twice_as_far_from_their_joints()
    {
        Rig rig = RigSubject.Of(BodyPlan.Upright).Rig;
        IReadOnlyList<CreatureSocket> twice = rig.Scaled(2f).Sockets;
        for (int i = 0; i < twice.Count; i++)
        {
            Assert.Equal(rig.Sockets[i] with { Position = 2f * rig.Sockets[i].Position }, twice[i]);
        }
    }

    /// <summary>Mean of a measure over the vertices near a place.</summary>
    private static float Mean(Vector3[] skin, Func<Vector3, float> measure, Vector3 place, float near) => skin.Where(p => Vector3.Distance(p, place) < near).Average(measure);

    private static (Vector3 Place, Vector3 X, Vector3 Y, Vector3 Z) Frame(Rig rig, CreatureSocket socket)
    {
        Quaternion joint = rig.Skeleton.ModelRotations[socket.Joint];
        Quaternion model = joint * socket.Rotation;
        Assert.Equal(1f, socket.Rotation.Length(), 1e-5f);
        return (rig.Skeleton.ModelPositions[socket.Joint] + Vector3.Transform(socket.Position, joint), Vector3.Transform(Vector3.UnitX, model), Vector3.Transform(Vector3.UnitY, model), Vector3.Transform(Vector3.UnitZ, model));
    }

    private static void Near(Vector3 expected, Vector3 actual) => Assert.True(Vector3.Distance(expected, actual) < 1e-4f, $"{actual} instead of {expected}");
}
