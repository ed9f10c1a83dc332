using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class AnatomicalWeightsTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Weights_are_at_most_four_in_descending_order_and_exactly_one_together(BodyPlan plan) =>
        SkinFacts.AreWellFormed(RigSubject.Of(plan).Weights, RigSubject.Of(plan).Skeleton);

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Left_and_right_are_exact_mirror_images(BodyPlan plan) => SkinFacts.AreMirrored(RigSubject.Of(plan).Weights, RigSubject.Of(plan));

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Nothing_is_moved_across_a_gap(BodyPlan plan) => SkinFacts.DoNotLeak(RigSubject.Of(plan).Weights, RigSubject.Of(plan));

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Solving_twice_gives_the_same_bits(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Assert.Equal(subject.Weights, AnatomicalWeights.Solve(subject.Input, subject.Rig));
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Every_bone_under_the_skin_moves_some_of_it(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        float[] most = new float[subject.Skeleton.Count];
        foreach (SkinWeights w in subject.Weights)
        {
            foreach ((int joint, float weight) in w.Influences())
            {
                most[joint] = Math.Max(most[joint], weight);
            }
        }

        for (int j = 2; j < most.Length; j++)
        {
            Joint joint = subject.Skeleton.Joints[j];
            bool separate = joint.Role is JointRole.End or JointRole.Eye or JointRole.Girdle;
            bool rigidSole = joint.Role == JointRole.Ball && subject.Rig.Limbs.Any(l => l.Joints.Contains(j) && l.Archetype == LimbArchetype.Column);
            Assert.True(separate || rigidSole || most[j] > 0.49f, $"{joint.Name} holds {most[j]} at most");
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void From_the_body_into_a_limb_its_share_rises_by_at_most_45_hundredths_along_an_edge(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Surface surface = subject.Input.Surface;
        for (int a = 0; a < subject.Input.Appendages.Count; a++)
        {
            Appendage appendage = subject.Input.Appendages[a];
            if (appendage.Archetype is LimbArchetype.Insect or LimbArchetype.Raptorial or LimbArchetype.Jumper || !(appendage.Kind is LimbKind.Leg or LimbKind.Arm or LimbKind.Wing or LimbKind.Ear))
            {
                // The joints of insects are hard, fins are thin.
                continue;
            }

            float[] share = Array.ConvertAll(subject.Weights, w => subject.Rig.Appendages[a].Left.Sum(j => w.Of(j)));
            for (int v = 0; v < share.Length; v++)
            {
                foreach (int n in subject.Input.Adjacency.Of(v))
                {
                    float most = appendage.Archetype == LimbArchetype.Sprawl ? 0.55f : 0.45f;
                    Assert.True(Math.Abs(share[v] - share[n]) <= most, $"{appendage.Kind} {appendage.Pair}: {share[v]} at {Describe(surface.Addresses[v])} beside {share[n]} at {Describe(surface.Addresses[n])}");
                }
            }
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void A_section_of_the_body_away_from_limbs_and_jaw_moves_as_one(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Surface surface = subject.Input.Surface;
        SocketSpread spread = SocketSpread.Measure(surface, subject.Input.Adjacency, subject.Input.Appendages);
        var sections = new Dictionary<float, SkinWeights>();
        for (int v = 0; v < subject.Weights.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            if (address.Region == SurfaceRegion.Body && address.Ring > subject.Input.Mouth.HingeRing && spread.First(v) < 0 && spread.First(surface.Mirror[v]) < 0)
            {
                sections.TryAdd(address.Ring, subject.Weights[v]);
                Assert.Equal(sections[address.Ring], subject.Weights[v]);
                Assert.True(subject.Weights[v].Weights.Z == 0f);
            }
        }

        Assert.True(sections.Count > 15);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_lower_lip_is_the_jaws_and_the_upper_is_not(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        MouthSeam mouth = subject.Input.Mouth;
        int jaw = subject.Rig.Jaw;
        Assert.Equal(mouth.Opens, jaw >= 0);
        for (int k = 1; k < mouth.LowerLip.Length - 1; k++)
        {
            Assert.Equal(1f, subject.Weights[mouth.LowerLip[k]].Of(jaw));
            Assert.Equal(0f, subject.Weights[mouth.UpperLip[k]].Of(jaw));
        }

        if (mouth.Opens)
        {
            Assert.Equal(0.5f, subject.Weights[mouth.LowerLip[0]].Of(jaw), 0.01f);
        }

        Surface surface = subject.Input.Surface;
        for (int v = 0; v < subject.Weights.Length && mouth.Opens; v++)
        {
            float share = subject.Weights[v].Of(jaw);
            VertexAddress address = surface.Addresses[v];
            switch (address.Region)
            {
                case SurfaceRegion.Mouth:
                    Assert.InRange(share, 0.2f, 0.8f);
                    break;
                case SurfaceRegion.Nose:
                    Assert.True(share is 0f or 1f);
                    break;
                case SurfaceRegion.Body when Math.Min(address.Segment, 32 - address.Segment) < 10 || address.Ring > mouth.HingeRing:
                    Assert.Equal(0f, share);
                    break;
                case SurfaceRegion.Body when Math.Min(address.Segment, 32 - address.Segment) > 10 && address.Ring <= mouth.CornerRing:
                    Assert.Equal(1f, share);
                    break;
            }
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Plantigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Upright)]
    public void Toes_follow_the_ball_of_the_foot_alone(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        int toes = 0;
        for (int v = 0; v < subject.Weights.Length; v++)
        {
            if (subject.Input.Surface.Addresses[v].Region == SurfaceRegion.Toe)
            {
                Assert.Equal(JointRole.Ball, subject.Skeleton.Joints[subject.Weights[v].Joint0].Role);
                Assert.Equal(1f, subject.Weights[v].Weights.X);
                toes++;
            }
        }

        Assert.True(toes > 100);
    }

    [Fact]
    public void The_sole_of_a_pillar_is_one_piece()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Columnar);
        int sole = 0;
        for (int v = 0; v < subject.Weights.Length; v++)
        {
            VertexAddress address = subject.Input.Surface.Addresses[v];
            if (address.Appendage < 0 || address.Region != SurfaceRegion.Leg)
            {
                continue;
            }

            Appendage leg = subject.Input.Appendages[address.Appendage];
            if (subject.Input.Surface.Positions[v].Y < 0.4f * leg.Joints[2].Y)
            {
                Assert.Equal(JointRole.Ankle, subject.Skeleton.Joints[subject.Weights[v].Joint0].Role);
                Assert.Equal(1f, subject.Weights[v].Weights.X);
                sole++;
            }
        }

        Assert.True(sole > 50);
    }

    [Fact]
    public void The_skin_around_a_socket_follows_the_limb_less_and_less()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Unguligrade);
        SocketSpread spread = SocketSpread.Measure(subject.Input.Surface, subject.Input.Adjacency, subject.Input.Appendages);
        float[] sum = new float[SocketSpread.Rings];
        int[] count = new int[SocketSpread.Rings];
        for (int v = 0; v < subject.Weights.Length; v++)
        {
            if (spread.First(v) >= 0 && subject.Input.Surface.Mirror[v] != v && subject.Input.Appendages[spread.Appendage(spread.First(v))].Kind == LimbKind.Leg)
            {
                int e = spread.First(v);
                sum[spread.Distance(e)] += subject.Weights[v].Of(subject.Rig.Appendages[spread.Appendage(e)].Left[1]);
                count[spread.Distance(e)]++;
            }
        }

        Assert.Equal(0.30f, sum[0] / count[0], 0.02f);
        Assert.Equal(0.14f, sum[1] / count[1], 0.02f);
        Assert.Equal(0.05f, sum[2] / count[2], 0.02f);
    }

    [Fact]
    public void A_swept_fins_tip_moves_as_one_however_the_body_bends()
    {
        RigSubject subject = RigSubject.WithSharkFin();
        int fin = Enumerable.Range(0, subject.Input.Appendages.Count).First(a => subject.Input.Appendages[a].Kind == LimbKind.Dorsal);
        int[] tip = Enumerable.Range(0, subject.Weights.Length).Where(v => subject.Input.Surface.Addresses[v].Appendage == fin && subject.Input.Surface.Addresses[v].Along == 1f).ToArray();
        foreach (int v in tip)
        {
            foreach (int n in subject.Input.Adjacency.Of(v))
            {
                if (tip.Contains(n))
                {
                    Assert.True(Change(subject.Weights[v], subject.Weights[n]) < 0.35f);
                }
            }
        }

        Assert.True(tip.Length > 6);
    }

    private static string Describe(in VertexAddress address) => $"{address.Region} {address.Along} ring {address.Ring}";

    private static float Change(SkinWeights a, SkinWeights b) =>
        a.Influences().Concat(b.Influences()).Select(i => i.Joint).Distinct().Sum(j => Math.Abs(a.Of(j) - b.Of(j))) / 2f;
}
