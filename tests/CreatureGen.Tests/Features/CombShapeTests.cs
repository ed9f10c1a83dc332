using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class CombShapeTests
{
    private static readonly Vector3 red = new(0.46f, 0.02f, 0.03f);

    [Theory]
    [InlineData(0)]
    [InlineData(12.6)]
    public void Flesh_is_closed_and_rooted_in_the_skin_of_every_cock(double segment)
    {
        foreach (CreatureBlueprint blueprint in SpeciesTests.Drawn("rooster", RequestedKind.Walking))
        {
            FeatureBlueprint feature = blueprint.Features.Single(part => part.Kind == FeatureKind.Comb && part.Segment == segment);
            Piece piece = Build(feature, SkinOf(blueprint));
            PieceChecks.IsSound(piece);
            Assert.All(piece.Colours, colour => Assert.True(colour.X > 4 * colour.Y, "flesh is red"));
        }
    }

    [Fact]
    public void A_comb_stands_upon_the_midline_with_its_highest_lobe_between_lower_ones()
    {
        CreatureBlueprint blueprint = SpeciesTests.Drawn("rooster", RequestedKind.Walking).First();
        FeatureBlueprint feature = blueprint.Features.Single(part => part.Kind == FeatureKind.Comb && part.Segment == 0);
        BodySkin skin = SkinOf(blueprint);
        Piece piece = Build(feature, skin);
        PieceChecks.IsSymmetric(piece);
        Vector3 top = piece.Positions.MaxBy(position => position.Y);
        float crown = skin.At(feature.Ring, 0).Position.Y;
        Assert.InRange(top.Y - crown, 0.8f * (float)feature.Length, 1.05f * (float)feature.Length);
        float front = piece.Positions.Max(position => position.Z);
        float rear = piece.Positions.Min(position => position.Z);
        Assert.InRange(top.Z, rear + (0.25f * (front - rear)), front - (0.25f * (front - rear)));
    }

    [Fact]
    public void A_part_at_the_tip_of_the_nose_is_built_as_well()
    {
        CreatureBlueprint blueprint = SpeciesTests.Drawn("rooster", RequestedKind.Walking).First();
        FeatureBlueprint feature = blueprint.Features.First(part => part.Kind == FeatureKind.Comb) with { Ring = 0 };
        PieceChecks.IsSound(Build(feature, SkinOf(blueprint)));
    }

    private static Piece Build(FeatureBlueprint feature, BodySkin skin)
    {
        var builder = new PieceBuilder();
        CombShape.Append(builder, feature, skin, red);
        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
    }

    private static BodySkin SkinOf(CreatureBlueprint blueprint) =>
        BodySkin.Span(BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail), blueprint);
}
