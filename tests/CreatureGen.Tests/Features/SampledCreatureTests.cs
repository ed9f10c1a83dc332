using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class SampledCreatureTests
{
    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void The_small_parts_of_sampled_creatures_are_sound(LocomotionKind kind)
    {
        var builder = new PieceBuilder();
        for (ulong seed = 0; seed < 40; seed++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, kind);
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            BodySkin skin = BodySkin.Span(shape, blueprint);
            EyeBlueprint eye = blueprint.Head.Eyes;
            EyeFrame frame = EyeFrame.On(skin.At(eye.Ring, eye.Segment), eye, shape.Forward((int)eye.Ring), 1f);
            EyeShape.Append(builder, frame, eye.Style, Vector3.One * 0.5f);
            LidShape.Append(builder, frame, eye, LidPart.Upper, Vector3.One * 0.5f);
            LidShape.Append(builder, frame, eye, LidPart.Lower, Vector3.One * 0.5f);
            Check(builder);
            foreach (FeatureBlueprint feature in blueprint.Features)
            {
                var curve = new FeatureCurve(feature, skin.At(feature.Ring, feature.Segment), shape.Forward((int)feature.Ring), Vector3.UnitY, 1f);
                if (feature.Kind is FeatureKind.Antenna or FeatureKind.Lure)
                {
                    AntennaShape.Append(builder, feature, curve, 1f, Vector3.One * 0.5f, Vector3.One);
                }
                else if (feature.Kind == FeatureKind.Antler)
                {
                    AntlerShape.Append(builder, feature, curve, 1f, Vector3.One * 0.5f);
                }
                else if (feature.Kind == FeatureKind.Tail)
                {
                    TailShape.Append(builder, feature, curve, (_, _) => Vector3.One);
                }
                else if (feature.Kind == FeatureKind.Eye)
                {
                    StalkShape.Append(builder, curve, 0.5f * (float)feature.Radius, Vector3.One, Vector3.One);
                }
                else
                {
                    HornShape.Append(builder, feature, curve, 1f, Vector3.One * 0.5f);
                }

                Check(builder);
            }

            foreach (InsectWingBlueprint wing in blueprint.InsectWings)
            {
                InsectWingShape.Append(builder, skin.At(wing.Ring, wing.Segment), wing, 1f, Vector3.One, Vector3.Zero);
                Check(builder);
            }
        }
    }

    private static void Check(PieceBuilder builder)
    {
        PieceChecks.IsSound(builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere));
        builder.Clear();
    }
}
