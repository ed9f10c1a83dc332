using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class ViewTests
{
    /// <summary>Least part of the surface of a far wing that is seen of it; from 38 degrees beside the front and 14 above it was .11 of the one least seen: no more than its edge.</summary>
    private const float LeastSeen = 0.19f;

    /// <summary>Least part of the breadth of the picture between snout and tail from behind.</summary>
    private const float BesideTheTail = 0.25f;

    /// <summary>Greatest distance of the far end of a body relative to that of its near end; through a portrait lens it was more than three times as far.</summary>
    private const float FarEnd = 2.5f;

    [Theory]
    [InlineData("three-quarter", View.ThreeQuarter)]
    [InlineData("side", View.Side)]
    [InlineData("front", View.Front)]
    [InlineData("back", View.Back)]
    [InlineData("top", View.Top)]
    public void Every_word_finds_its_view_and_back(string word, View view)
    {
        Assert.True(Views.TryParse(word, out View found));
        Assert.Equal(view, found);
        Assert.Equal(word, Views.Word(view));
    }

    [Fact]
    public void Every_view_has_a_word_and_an_angle()
    {
        Assert.Equal(5, Enum.GetValues<View>().Select(Views.Word).Distinct(StringComparer.Ordinal).Count());
        Assert.Equal(5, Enum.GetValues<View>().Select(Views.Angle).Distinct().Count());
    }

    [Theory]
    [InlineData("")]
    [InlineData("Side")]
    [InlineData("side ")]
    [InlineData("bottom")]
    [InlineData("threequarter")]
    public void Other_words_find_nothing(string word) => Assert.False(Views.TryParse(word, out _));

    [Theory]
    [InlineData((View)5)]
    [InlineData((View)(-1))]
    public void Numbers_that_are_no_view_are_refused(View view)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Views.Angle(view));
        Assert.Throws<ArgumentOutOfRangeException>(() => Views.Word(view));
    }

    [Fact]
    public void In_three_quarter_view_both_wings_show_their_blades_in_the_air()
    {
        int wings = 0;
        foreach (int seed in Enumerable.Range(20200000, 24))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (!creature.Blueprint.Wings.Any(wing => wing.Style != WingStyle.Folded))
            {
                continue;
            }

            RenderMesh inTheAir = MomentOfMotion.Of(creature);
            Camera camera = Camera.Fit(Views.Angle(View.ThreeQuarter, creature), inTheAir.Positions, 1.2f);
            foreach (LimbChain wing in creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing))
            {
                float seen = Seen(creature, inTheAir.Positions, wing, camera.Eye);
                Assert.True(seen > LeastSeen, FormattableString.Invariant($"{seed}: {seen} of it is seen"));
                wings++;
            }
        }

        Assert.True(wings > 12);
    }

    /// <summary>From straight behind and 6 degrees above, a raised fluke or a tail was before the head of all of these.</summary>
    [Theory]
    [InlineData(24750003, RequestedKind.Swimming)]
    [InlineData(24750006, RequestedKind.Swimming)]
    [InlineData(24750007, RequestedKind.Swimming)]
    [InlineData(24750001, RequestedKind.Walking)]
    [InlineData(24750010, RequestedKind.Flying)]
    public void From_behind_the_head_is_seen_beside_the_tail(int seed, RequestedKind kind)
    {
        Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = kind });
        RenderMesh mesh = MomentOfMotion.Of(creature, kind == RequestedKind.Flying ? JointRole.Wing : null);
        Camera camera = Camera.Fit(Views.Angle(View.Back, creature), mesh.Positions, 1.2f, fieldOfViewDegrees: Views.FieldOfView(View.Back));
        ReadOnlySpan<Vector3> joints = creature.Skeleton.ModelPositions;
        Vector3 snout = Vector3.Zero;
        Vector3 tail = Vector3.Zero;
        foreach (Vector3 joint in joints)
        {
            bool middle = Math.Abs(joint.X) < 1e-5f;
            snout = middle && joint.Z > snout.Z ? joint : snout;
            tail = middle && joint.Z < tail.Z ? joint : tail;
        }

        float beside = Math.Abs(camera.Project(snout, 1200, 1000).X - camera.Project(tail, 1200, 1000).X) / 1200f;
        Assert.True(beside > BesideTheTail, FormattableString.Invariant($"the snout is {beside} of the picture beside the tail"));
    }

    [Theory]
    [InlineData(24750006, RequestedKind.Swimming)]
    [InlineData(24750001, RequestedKind.Walking)]
    public void Along_a_body_what_is_near_is_less_than_two_and_a_half_times_as_large_as_what_is_far(int seed, RequestedKind kind)
    {
        Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = kind });
        RenderMesh mesh = MomentOfMotion.Of(creature);
        foreach (View view in new[] { View.Front, View.Back })
        {
            Camera camera = Camera.Fit(Views.Angle(view, creature), mesh.Positions, 1.2f, fieldOfViewDegrees: Views.FieldOfView(view));
            float[] away = [.. mesh.Positions.ToArray().Select(position => camera.Project(position, 1200, 1000).Z)];
            Assert.InRange(away.Max() / away.Min(), 1f, FarEnd);
        }
    }

    /// <summary>Area of one side of a limb's skin as it is seen from a place, relative to its own.</summary>
    private static float Seen(Creature creature, ReadOnlySpan<Vector3> positions, LimbChain limb, Vector3 eye)
    {
        ReadOnlySpan<int> triangles = creature.Mesh.Triangles;
        float seen = 0f;
        float whole = 0f;
        for (int i = 0; i < triangles.Length; i += 3)
        {
            if (limb.Joints.Contains(creature.Mesh.Weights[triangles[i]].Joint0))
            {
                Vector3 a = positions[triangles[i]];
                Vector3 across = Vector3.Cross(positions[triangles[i + 1]] - a, positions[triangles[i + 2]] - a);
                seen += Math.Max(0f, Vector3.Dot(across, Vector3.Normalize(eye - a)));
                whole += across.Length() / 2f;
            }
        }

        return seen / whole;
    }
}
