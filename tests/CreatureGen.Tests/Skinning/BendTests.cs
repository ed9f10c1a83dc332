using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

/// <summary>Bends of every plan's skin keep its volume and do not turn it inside out.</summary>
public sealed class BendTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Hips_swing_35_degrees_both_ways(BodyPlan plan)
    {
        Holds(plan, 0.03, 0.005, j => j.Role == JointRole.Hip ? X(35) : null);
        Holds(plan, 0.03, 0.005, j => j.Role == JointRole.Hip ? X(-35) : null);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Knees_fold_60_degrees(BodyPlan plan) => Holds(plan, 0.04, 0.008, j => j.Role == JointRole.Knee ? X(60 * Fold(j)) : null);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Ankles_fold_50_degrees(BodyPlan plan) => Holds(plan, 0.02, 0.006, j => j.Role == JointRole.Ankle ? X(50 * Fold(j)) : null);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Necks_and_heads_turn_to_their_limits(BodyPlan plan)
    {
        Holds(plan, 0.05, 0.02, j => j.Role is JointRole.Neck or JointRole.Head ? Rotation.FromAxisAngle(Vector3.UnitX, j.Limit.SwingX.Min) : null);
        Holds(plan, 0.05, 0.02, j => j.Role is JointRole.Neck or JointRole.Head ? Rotation.FromAxisAngle(Vector3.UnitZ, j.Limit.SwingZ.Max) : null);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Spines_and_tails_bend_sideways_to_their_limits(BodyPlan plan) =>
        // A cobra's hood is wide for the length of its bones.
        Holds(plan, plan == BodyPlan.Legless ? 0.08 : 0.05, 0.02, j => j.Role is JointRole.Spine or JointRole.Tail or JointRole.Chest ? Rotation.FromAxisAngle(Vector3.UnitZ, j.Limit.SwingZ.Max) : null);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Tails_rise_15_degrees_in_each_bone(BodyPlan plan) => Holds(plan, 0.02, 0.005, j => j.Role == JointRole.Tail ? X(Math.Min(15, Scalar.Degrees(j.Limit.SwingX.Max))) : null);

    /// <summary>Their roots are a larger share of a slender body than of a stout one: two hundredths in the mean of eight bodies, three at most.</summary>
    [Fact]
    public void Wings_beat_45_degrees_up_and_down_and_fold()
    {
        RigSubject[] fliers = RigSubject.Several(BodyPlan.Flapping, 8);
        HoldsOn(fliers, 0.002, j => j.Role == JointRole.Wing && j.Name.EndsWith("_1", StringComparison.Ordinal) ? X(45) : null);
        HoldsOn(fliers, 0.002, j => j.Role == JointRole.Wing && j.Name.EndsWith("_1", StringComparison.Ordinal) ? X(-45) : null);
        HoldsOn(fliers, 0.01, j => j.Role == JointRole.Wing && j.Name.EndsWith("_3", StringComparison.Ordinal) ? Rotation.FromAxisAngle(Vector3.UnitZ, 0.5 * (j.Side == Side.Left ? 1 : -1)) : null);

        static void HoldsOn(RigSubject[] subjects, double inverted, Func<Joint, Quaternion?> turn)
        {
            (double Volume, double Inverted)[] bends = Array.ConvertAll(subjects, subject => SkinFacts.Bend(subject, subject.Weights, turn));
            Assert.InRange(bends.Average(bend => Math.Abs(bend.Volume)), 0, 0.02);
            Assert.All(bends, bend => Assert.InRange(bend.Volume, -0.03, 0.03));
            Assert.All(bends, bend => Assert.InRange(bend.Inverted, 0, inverted));
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Jaws_open_20_degrees_and_fins_and_ears_lean(BodyPlan plan)
    {
        Holds(plan, 0.08, 0.004, j => j.Role == JointRole.Jaw ? X(20) : null);
        Holds(plan, 0.02, 0.01, j => j.Role is JointRole.Fin or JointRole.Ear ? Rotation.FromAxisAngle(Vector3.UnitZ, 0.3 * (j.Side == Side.Right ? -1 : 1)) : null);
    }

    private static Quaternion X(double degrees) => Rotation.FromAxisAngle(Vector3.UnitX, Scalar.Radians(degrees));

    private static double Fold(Joint joint) => joint.Limit.SwingX.Max > -joint.Limit.SwingX.Min ? 1 : -1;

    private static void Holds(BodyPlan plan, double volume, double inverted, Func<Joint, Quaternion?> turn)
    {
        RigSubject subject = RigSubject.Of(plan);
        (double change, double share) = SkinFacts.Bend(subject, subject.Weights, turn);
        Assert.True(Math.Abs(change) <= volume, $"the volume changes by {change:P2}");
        Assert.True(share <= inverted, $"{share:P2} of the triangles turn inside out");
    }
}
