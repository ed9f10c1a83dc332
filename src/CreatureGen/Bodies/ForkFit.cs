using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>Finds where a body may fork into two necks, how far these lean apart and how long they are, so that both heads have room beside each other.</summary>
internal static class ForkFit
{
    /// <summary>Room that a head has beside the other, in parts of what it takes.</summary>
    private const double HeadRoom = 1.1;

    /// <summary>Half the room between both necks behind the heads, in half widths of a neck there: with less of it two faces are on one neck.</summary>
    private const double NeckRoom = 0.4;

    /// <summary>Least length of a swimmer's neck in half widths of it: on land a head is lifted off the trunk, in the water two heads of a body without a neck are one mass.</summary>
    private const double SwimmersNeck = 2;

    // Radians: necks that lean more are arms. Necks too short to lean apart are longer than with one head, so far that they still belong to the body.
    private static readonly double[] spreads = { 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75 };
    private static readonly double[] lengths = { 1, 1.15, 1.3, 1.45 };

    /// <summary>What twice the length of a neck is worth in radians of spread.</summary>
    private const double LengthCost = 0.8;

    /// <summary>The fork that changes the body least; null where none of its necks would do.</summary>
    public static ForkBlueprint? Find(CreatureBlueprint blueprint, BodyShape shape, double size)
    {
        int ring = ForkRules.RingOf(blueprint);
        if (ring < 0 || BlueprintValidator.Validate(blueprint with { Fork = new ForkBlueprint(ring, spreads[0], 1, size) }).Count > 0)
        {
            return null;
        }

        double half = Math.Max(HeadRoom * size * HalfWidth(blueprint, shape), (size + NeckRoom) * shape.Width[ForkCourse.Rigid]);
        ForkBlueprint? best = null;
        double least = double.PositiveInfinity;
        double neck = (shape.Arc[ring] - shape.Arc[ForkCourse.Rigid]) / shape.Width[ForkCourse.Rigid];
        foreach (double length in lengths)
        {
            if (blueprint.Kind == LocomotionKind.Swimming && length * neck < SwimmersNeck)
            {
                continue;
            }

            foreach (double spread in spreads)
            {
                double cost = spread + (LengthCost * (length - 1));
                var fork = new ForkBlueprint(ring, spread, length, size);
                if (cost < least && new ForkCourse(shape, fork).Apart >= half)
                {
                    (best, least) = (fork, cost);
                }
            }
        }

        return best;
    }

    /// <summary>How far the head reaches to the side, with what grows on it, metres.</summary>
    private static double HalfWidth(CreatureBlueprint blueprint, BodyShape shape)
    {
        BodySkin skin = BodySkin.Span(shape, blueprint);
        double widest = 0;
        for (int i = 0; i <= ForkCourse.Rigid; i++)
        {
            for (int j = 1; j < BodyGrid.Segments / 2; j++)
            {
                widest = Math.Max(widest, skin[i, j].X);
            }
        }

        foreach (EarBlueprint ear in blueprint.Ears)
        {
            SurfacePoint root = skin.At(ear.Socket.Ring + (ear.Socket.Rows / 2.0), ear.Socket.Segment + (ear.Socket.Columns / 2.0));
            var direction = new Vector3((float)ear.Outward, (float)ear.Upward, (float)ear.Forward);
            widest = Math.Max(widest, root.Position.X + (ear.Length * Vec.Normalize(direction, Vector3.UnitY).X) + (0.5 * ear.Width));
        }

        foreach (FeatureBlueprint part in blueprint.Features)
        {
            if (part.Ring <= ForkCourse.Rigid && part.Segment is > 0 and < BodyGrid.Segments / 2)
            {
                widest = Math.Max(widest, Reach(skin.At(part.Ring, part.Segment), part, shape.Forward((int)part.Ring)));
            }
        }

        foreach (FrillBlueprint frill in blueprint.Frills)
        {
            widest = Math.Max(widest, BodyShape.At(shape.Width, frill.Ring) + (frill.Length * PortableMath.Cos(frill.Tilt)));
        }

        return widest;
    }

    private static double Reach(SurfacePoint skin, FeatureBlueprint part, Vector3 forward)
    {
        Vector3 direction = (skin.Normal * (float)part.Outward) + (Vector3.UnitY * (float)part.Upward) + (forward * (float)part.Forward) + (Vector3.UnitX * (float)part.Sideward);
        return skin.Position.X + Math.Max(0, part.Length * (Vec.Normalize(direction, skin.Normal).X + part.BendSide)) + part.Radius;
    }
}
