using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>Sets nostrils on the front of a nose of leather, on the sides of a bare snout, and at the root of a beak.</summary>
internal static class NostrilSetter
{
    /// <summary>Squareness from which on a muzzle ends in a nose of leather.</summary>
    private const double LeatherFrom = 2.5;

    // Half width of a nostril, in those that its species tells of the muzzle's half width, or of that of its leather.
    private const double Breadth = 0.8;
    private const double OnLeather = 1.05;
    private const double InBeak = 0.75;

    /// <summary>Part of the direction of the muzzle in that of a nostril on its front.</summary>
    private const float Ahead = 0.85f;

    /// <summary>Appends both nostrils of a creature that has any. They move with the head.</summary>
    /// <param name="builder">Where they go.</param>
    /// <param name="blueprint">The creature.</param>
    /// <param name="grown">Its surface.</param>
    /// <param name="coat">Its colours.</param>
    /// <param name="beak">The beak that they are in; null for none.</param>
    public static void Append(PieceBuilder builder, CreatureBlueprint blueprint, GrownSurface grown, CoatPainter coat, BeakSetter? beak)
    {
        CoatPalette palette = coat.Palette;
        BodyShape shape = grown.Skin.Shape;
        double size = blueprint.Head.NostrilSize;
        if (beak != null)
        {
            Vector3 colour = beak.IsNostrilSoft ? BeakSetter.SoftColour(palette, coat.BeakColour) : coat.BeakColour;
            NostrilShape.Append(builder, beak.Nostril, shape.Forward(StationRing.MuzzleMiddle), (float)(InBeak * shape.Width[StationRing.MuzzleMiddle] * size), colour);
        }
        else if (blueprint.Head.MuzzleSquareness > LeatherFrom)
        {
            var pad = new NosePad(shape);
            NostrilShape.Append(builder, OnFront(grown.Surface, pad), pad.Up, (float)(OnLeather * pad.HalfWidth * size), palette.Muzzle);
        }
        else
        {
            bool painted = SpeciesCatalogue.Find(blueprint.Body.Blend.Face).Snout == SnoutKind.Beak;
            NostrilShape.Append(builder, grown.Skin.At(painted ? 3.5 : 1.2, 4.6), shape.Up(StationRing.Nostrils), (float)(Breadth * shape.Width[StationRing.Nostrils] * size), palette.Base);
        }

        builder.AppendMirrored(0, 0);
    }

    /// <summary>The skin before the place of the left nostril: where it is met first from ahead.</summary>
    private static SurfacePoint OnFront(Surface surface, NosePad pad)
    {
        Vector3 at = pad.Nostril;
        float farthest = 0f;
        Vector3 outward = pad.Forward;
        for (int t = 0; t < surface.Triangles.Length; t += 3)
        {
            int first = surface.Triangles[t];
            if (surface.Addresses[first].Ring > StationRing.MuzzleFront || surface.Addresses[first].Appendage >= 0)
            {
                continue;
            }

            Vector3 a = surface.Positions[first] - at;
            Vector3 b = surface.Positions[surface.Triangles[t + 1]] - at;
            Vector3 c = surface.Positions[surface.Triangles[t + 2]] - at;
            Vector2 p = Seen(a), q = Seen(b), r = Seen(c);

            // Areas of the triangles that the place makes with the edges, as seen from ahead: where all are of one sign, it lies within.
            float u = Area(q, r), v = Area(r, p), w = Area(p, q);
            float whole = u + v + w;
            if (whole == 0f || u / whole < 0f || v / whole < 0f || w / whole < 0f)
            {
                continue;
            }

            float ahead = Vec.Dot(((a * u) + (b * v) + (c * w)) / whole, pad.Forward);
            if (ahead > farthest)
            {
                farthest = ahead;
                outward = Vec.Normalize(Vec.Cross(b - a, c - a), pad.Forward);
            }
        }

        return new SurfacePoint(at + (pad.Forward * farthest), Vec.Normalize((outward * (1f - Ahead)) + (pad.Forward * Ahead), pad.Forward));

        Vector2 Seen(Vector3 point) => new(point.X, Vec.Dot(point, pad.Up));
    }

    private static float Area(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);
}
