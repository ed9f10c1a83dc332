using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Draws hair and collars: those of the families, and any kit in the size of its wearer.</summary>
internal static class NeckSampler
{
    /// <summary>Metres between hanging hair and the ground.</summary>
    private const double Clearance = 0.05;

    /// <summary>First ring of hair that hangs from a tail.</summary>
    private const int TailRing = 44;

    /// <summary>The hair that furred families wear now and then; whether there is any.</summary>
    public static bool Hair(CreatureDraft draft, double plenty, RandomStream random)
    {
        bool hoofed = draft.Species.Family == "bovine" && draft.Plan is BodyPlan.Unguligrade or BodyPlan.Centaur;
        double chance = draft.Kind == LocomotionKind.Swimming ? 0 : draft.Species.Family switch { "canine" => 0.22, "feline" => 0.22, "bovine" when hoofed => 0.3, _ => 0 };
        double size = random.Uniform();
        bool ruffed = random.Chance(draft.Species.Family == "feline" ? 0.4 : 0.15);
        if (!random.Chance(chance * plenty))
        {
            return false;
        }

        Add(draft, hoofed ? NeckKits.Falling : ruffed ? NeckKits.Ruff : NeckKits.Bristles, size);
        return true;
    }

    /// <summary>The collar that lizards wear now and then; whether there is one.</summary>
    public static bool Collar(CreatureDraft draft, double plenty, RandomStream random)
    {
        bool fits = draft.Species.Family == "reptile" && draft.Kind == LocomotionKind.Walking && draft.Ears.Count == 0;
        bool bony = random.Chance(draft.Plan is BodyPlan.Plantigrade ? 0.6 : 0.25);
        double size = random.Uniform();
        if (!random.Chance(0.14 * plenty) || !fits)
        {
            return false;
        }

        Add(draft, bony ? NeckKits.Shield : NeckKits.Fan, size);
        return true;
    }

    /// <summary>Adds hair; <paramref name="size"/> 0..1 goes from its least length to its most.</summary>
    public static void Add(CreatureDraft draft, in ManeKit kit, double size)
    {
        double factor = Scalar.Lerp(kit.Least, kit.Most, size);
        double unit = draft.HalfDepth(19);
        foreach (ManeBlueprint mane in kit.Fields)
        {
            draft.Manes.Add(OffGround(draft, mane with { Length = mane.Length * factor * unit, Width = mane.Width * Math.Sqrt(factor) * unit }));
        }
    }

    /// <summary>Adds a collar; <paramref name="size"/> 0..1 goes from its least length to its most.</summary>
    public static void Add(CreatureDraft draft, in FrillKit kit, double size)
    {
        double unit = draft.Shape.Width[13];
        draft.Frills.Add(kit.Frill with { Length = kit.Frill.Length * Scalar.Lerp(kit.Least, kit.Most, size) * unit, Thickness = kit.Frill.Thickness * unit });
    }

    /// <summary>Hair of a tail, shortened until it clears the ground.</summary>
    public static ManeBlueprint OffGround(CreatureDraft draft, ManeBlueprint mane)
    {
        if (draft.Kind != LocomotionKind.Walking || mane.Ring < TailRing)
        {
            return mane;
        }

        var s = draft.Shape;
        const int end = BodyGrid.Rings - 1;
        double free = Math.Max(0, s.Y[end] - Clearance);
        double longest = s.Arc[end] - s.Arc[(int)mane.LastRing] + (0.8 * free);
        double length = mane.Length * Math.Max(1, mane.Growth);
        return length > longest ? mane with { Length = mane.Length * longest / length } : mane;
    }
}
