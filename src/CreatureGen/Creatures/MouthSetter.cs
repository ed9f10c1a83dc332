using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Limbs;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>Lays tongues into mouths.</summary>
internal static class MouthSetter
{
    // Half width of a tongue in half widths of the mouth.
    private const float Broad = 0.76f;
    private const float InBeak = 0.5f;
    private const float Forked = 0.2f;

    // Share of the lip that a tongue reaches along; in a beak it ends before the hook.
    private const float Reach = 0.95f;
    private const float ReachInBeak = 0.6f;

    /// <summary>Appends the tongue of a creature whose mouth opens, as it lies in the mouth at rest. It moves with the jaw.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="blueprint">The creature.</param>
    /// <param name="grown">Its surface.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void AppendTongue(PieceBuilder builder, CreatureBlueprint blueprint, GrownSurface grown, Vector3 colour)
    {
        BodyShape shape = grown.Skin.Shape;
        var lip = new Vector3[grown.Mouth.CornerRing + 1];
        for (int k = 0; k < lip.Length; k++)
        {
            lip[k] = grown.Surface.Positions[grown.Mouth.LowerLip[k]];
        }

        int middle = grown.Mouth.CornerRing / 2;
        bool beaked = SpeciesCatalogue.Find(blueprint.Body.Blend.Face).Snout == SnoutKind.Beak;
        var floor = new MouthFloor(lip, shape.Up(middle), beaked ? ReachInBeak : Reach, (float)Math.Min(shape.Bottom[middle], shape.Bottom[StationRing.Nostrils]));
        if (blueprint.Head.Mouth.Tongue == TongueStyle.Forked)
        {
            TongueShape.AppendForked(builder, floor, Forked, colour);
        }
        else
        {
            TongueShape.AppendRounded(builder, floor, beaked ? InBeak : Broad, colour);
        }
    }
}
