using CreatureGen.Anatomy;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class SpineSegmentsTests
{
    private static readonly SpineSegments Spine = new(new[] { 7, 8, 9 }, new[] { 1.0, 1.5 }, 4.0);

    [Theory]
    [InlineData(0.0, 7, 0f)]
    [InlineData(0.75, 7, 0f)]
    [InlineData(1.25, 8, 0f)]
    [InlineData(1.75, 9, 0f)]
    [InlineData(4.0, 9, 0f)]
    public void The_middle_of_a_bone_is_its_own(double arc, int joint, float second)
    {
        SpineBlend blend = Spine.At(arc);
        Assert.Equal((joint, second), (blend.Dominant, blend.SecondWeight));
    }

    [Fact]
    public void A_pivot_is_shared_evenly()
    {
        SpineBlend blend = Spine.At(1.0);
        Assert.Equal((7, 8, 0.5f), (blend.First, blend.Second, blend.SecondWeight));
    }

    [Fact]
    public void Around_a_pivot_the_share_follows_smoothstep_over_48_hundredths_of_the_shorter_bone()
    {
        // A quarter of the way into the stretch of 0.24 on either side.
        SpineBlend blend = Spine.At(1.0 - 0.12);
        Assert.Equal(0.25f * 0.25f * (3f - 0.5f), blend.SecondWeight, 1e-6f);
        Assert.Equal(0f, Spine.At(1.0 - 0.241).SecondWeight);
        Assert.True(Spine.At(1.0 - 0.239).SecondWeight > 0f);
    }

    [Fact]
    public void Bones_of_no_length_give_no_nonsense()
    {
        var spine = new SpineSegments(new[] { 1, 2, 3 }, new[] { 1.0, 1.0 }, 2.0);
        Assert.Equal(1, spine.At(0.9).Dominant);
        Assert.Equal(3, spine.At(1.1).Dominant);
        Assert.Equal(0f, spine.At(1.0).SecondWeight);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Along_every_spine_shares_change_without_a_jump_and_never_turn_back(BodyPlan plan)
    {
        Rig rig = RigSubject.Of(plan).Rig;
        double before = -1;
        for (int i = 0; i <= 20000; i++)
        {
            SpineBlend blend = rig.Spine.At(rig.Line.Length * i / 20000);
            double place = rig.Spine.BoneOf(blend.First) + ((rig.Spine.BoneOf(blend.Second) - rig.Spine.BoneOf(blend.First)) * blend.SecondWeight);
            Assert.True(before < 0 || (place >= before && place - before < 0.05), $"{before} → {place} at {i}");
            before = place;
        }

        Assert.Equal(rig.Spine.Joints.Length - 1, before);
    }

    [Fact]
    public void The_spines_line_finds_the_ring_of_an_arc_length()
    {
        SpineLine line = RigSubject.Of(BodyPlan.Unguligrade).Rig.Line;
        for (double ring = 0; ring <= 54; ring += 0.37)
        {
            Assert.Equal(ring, line.RingAt(line.ArcAt(ring)), 6);
        }

        Assert.Equal(0, line.RingAt(-1));
        Assert.Equal(54, line.RingAt(line.Length + 1));
    }
}
