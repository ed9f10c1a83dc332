using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class PortraitTests
{
    private static readonly RenderOptions plain = TestMeshes.Plain with { Width = 160, Height = 120, Shading = ShadingMode.Smooth, Samples = SampleCount.Four };

    [Theory]
    [MemberData(nameof(PreviewSubjects.SeedsAndViews), MemberType = typeof(PreviewSubjects))]
    public void A_creature_stays_off_the_border_by_the_margin(ulong seed, View view)
    {
        Picture picture = Portrait.Take(PreviewSubjects.Of(seed), view, plain);
        var covered = Enumerable.Range(0, 160 * 120).Where(i => picture[i % 160, i / 160].A > 0).Select(i => (X: i % 160, Y: i / 160)).ToArray();
        Assert.True(covered.Length > 160 * 120 / 60, $"only {covered.Length} pixels are covered");
        int left = covered.Min(p => p.X);
        int right = 159 - covered.Max(p => p.X);
        int top = covered.Min(p => p.Y);
        int bottom = 119 - covered.Max(p => p.Y);

        // The margin of 7 % is 11.2 and 8.4 pixels.
        Assert.True(Math.Min(left, right) >= 11 && Math.Min(top, bottom) >= 8, $"{left} {right} {top} {bottom} pixels of room");
    }

    [Fact]
    public void A_skeleton_shows_through_its_creature()
    {
        Creature creature = PreviewSubjects.Of(2);
        Picture solid = Portrait.Take(creature, View.Side, plain);
        Picture bones = Portrait.TakeSkeleton(creature, View.Side, plain);
        int ghost = 0;
        int opaque = 0;
        for (int i = 0; i < 160 * 120; i++)
        {
            if (solid[i % 160, i / 160].A == 255)
            {
                byte a = bones[i % 160, i / 160].A;
                ghost += a < 128 ? 1 : 0;
                opaque += a == 255 ? 1 : 0;
            }
        }

        Assert.True(ghost > 500, $"{ghost} pixels of the creature are half transparent");
        Assert.True(opaque > 100, $"{opaque} pixels of the creature are bones");
    }

    [Theory]
    [InlineData(1ul)]
    [InlineData(2ul)]
    [InlineData(3ul)]
    [InlineData(4ul)]
    public void An_eye_is_larger_in_a_close_up_of_the_face(ulong seed)
    {
        Creature creature = PreviewSubjects.Of(seed);
        ILookup<bool, Pixel> colours = Enumerable.Range(0, creature.Mesh.Positions.Length).ToLookup(
            i => creature.Skeleton.Joints[creature.Mesh.Weights[i].Joint0].Role == JointRole.Eye,
            i => TestMeshes.Srgb(creature.Mesh.Colours[i]));
        var eye = new HashSet<Pixel>(colours[true].Except(colours[false]));
        RenderOptions unlit = plain with { Shading = ShadingMode.Unlit, Samples = SampleCount.One };
        int whole = Count(Portrait.Take(creature, View.ThreeQuarter, unlit));
        int face = Count(Portrait.TakeFace(creature, View.ThreeQuarter, unlit));
        Assert.True(face > 10 && face > whole, $"{face} pixels of eyes in the close-up and {whole} in the whole picture");

        int Count(Picture picture) => Enumerable.Range(0, 160 * 120).Count(i => eye.Contains(picture[i % 160, i / 160]));
    }

    [Theory]
    [InlineData("cobra", RequestedKind.Walking, 0)]
    [InlineData("feline", RequestedKind.Walking, 0)]
    [InlineData("fish", RequestedKind.Swimming, 2)]
    public void A_portrait_is_taken_on_the_way_and_at_rest_the_halves_mirror_one_another(string body, RequestedKind kind, ulong seed)
    {
        Creature creature = SpeciesSubject.Of(body, kind, seed);
        Assert.InRange(Lopsidedness(Portrait.TakeAtRest(creature, View.Top, plain)), 0, 0.02);
        Assert.InRange(Lopsidedness(Portrait.Take(creature, View.Top, plain)), 0.03, 1);
    }

    [Fact]
    public void What_flies_is_seen_in_the_air_from_every_side_and_with_its_wings_as_broad_as_they_were_built_from_ahead()
    {
        Creature creature = SpeciesSubject.Of("heron", RequestedKind.Flying);
        RenderMesh built = RenderMesh.From(creature);
        RenderMesh ahead = MomentOfMotion.Of(creature, JointRole.Wing);
        Assert.All([View.Front, View.Back, View.Side], view => Assert.NotEqual(Portrait.TakeAtRest(creature, view, plain).Bytes.ToArray(), Portrait.Take(creature, view, plain).Bytes.ToArray()));
        Assert.True(Highest(MomentOfMotion.Of(creature)) > Highest(built));
        Assert.InRange(Broadest(ahead) / Broadest(built), 0.98f, 1.02f);
        Assert.True(Broadest(MomentOfMotion.Of(creature)) < 0.95f * Broadest(built));
        Assert.True(Tall(ahead) < 0.95f * Tall(built), "its legs hang");

        static float Highest(RenderMesh mesh) => mesh.Positions.ToArray().Max(position => position.Y);

        static float Broadest(RenderMesh mesh) => mesh.Positions.ToArray().Max(position => position.X);

        static float Tall(RenderMesh mesh) => Highest(mesh) - mesh.Positions.ToArray().Min(position => position.Y);
    }

    // Of the pixels of a creature seen from above, how many have none at the mirrored place. Its middle line is in the middle of the pictures of what stands straight.
    private static double Lopsidedness(Picture picture)
    {
        var covered = Enumerable.Range(0, 160 * 120).Where(i => picture[i % 160, i / 160].A > 0).ToArray();
        return covered.Count(i => picture[159 - (i % 160), i / 160].A == 0) / (double)covered.Length;
    }
}
