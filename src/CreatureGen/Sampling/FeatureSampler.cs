using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Draws ornaments, at most one kind on the head and one on the back, so that a creature looks designed.</summary>
internal static class FeatureSampler
{
    /// <summary>Metres between the tip of a part and the ground.</summary>
    private const double Clearance = 0.045;

    /// <summary>Fills in the features of the draft, as many as are asked for.</summary>
    public static void Sample(CreatureDraft draft, OrnamentLevel level)
    {
        double plenty = level switch { OrnamentLevel.None => 0, OrnamentLevel.Sparse => 0.4, OrnamentLevel.Rich => 2, _ => 1 };
        double head = draft.Shape.Width[13];
        if (draft.Species.Parts is PartSlot[] slots)
        {
            OwnParts(draft, slots, plenty, draft.Stream("own parts"));
            return;
        }

        if (draft.Species.Family == "insect")
        {
            InsectHead(draft, draft.Stream("insect head"));
            return;
        }

        bool horned = Horns(draft, head, plenty, draft.Stream("horns"));
        Tuft(draft, head, horned, plenty, draft.Stream("tuft"));
        Back(draft, horned, plenty, draft.Stream("back"));
    }

    /// <summary>From each slot of a species one choice.</summary>
    private static void OwnParts(CreatureDraft draft, PartSlot[] slots, double plenty, RandomStream random)
    {
        double head = draft.Proportions.Head;
        foreach (PartSlot slot in slots)
        {
            double[] weights = new double[slot.Choices.Length];
            for (int i = 0; i < weights.Length; i++)
            {
                bool empty = slot.Choices[i].Parts.Length == 0;
                weights[i] = slot.Choices[i].Weight * (empty ? 1 / Math.Max(plenty, 1e-6) : 1);
            }

            PartChoice choice = slot.Choices[random.Weighted(weights)];
            double size = random.Uniform();
            foreach (PartKit kit in choice.Parts)
            {
                FeatureBlueprint part = kit.Part;
                double factor = Maths.Scalar.Lerp(kit.Least, kit.Most, size) * (part.Ring < 16 ? head : 1);
                draft.Features.Add(OffGround(draft, part with { Length = part.Length * factor, Radius = part.Radius * Math.Sqrt(factor) }));
            }
        }
    }

    /// <summary>The part of a walker, bent up until its tip clears the ground.</summary>
    private static FeatureBlueprint OffGround(CreatureDraft draft, FeatureBlueprint part)
    {
        if (draft.Kind != LocomotionKind.Walking)
        {
            return part;
        }

        BodyShape s = draft.Shape;
        int ring = (int)part.Ring;
        double pitch = s.Pitch[ring];
        double around = Maths.PortableMath.Cos(Maths.PortableMath.Tau * part.Segment / BodyGrid.Segments);
        double root = s.Y[ring] + (around * Maths.PortableMath.Cos(pitch) * (around > 0 ? s.Top[ring] : s.Bottom[ring]));
        double rise = (part.Outward * around) + part.Upward + (part.Forward * Maths.PortableMath.Sin(pitch));
        double size = Math.Sqrt((part.Outward * part.Outward) + (part.Upward * part.Upward) + (part.Forward * part.Forward) + (part.Sideward * part.Sideward));
        double tip = root + (part.Length * ((rise / size) + part.BendUp));
        double missing = Clearance + (2 * part.Radius) - tip;
        return missing > 0 ? part with { BendUp = Math.Min(3, part.BendUp + (missing / part.Length)) } : part;
    }

    private static bool Horns(CreatureDraft draft, double head, double plenty, RandomStream random)
    {
        double chance = draft.Species.HeadOrnament.Horns * plenty;
        chance *= draft.Signature == Signature.BigEyes ? 0.4 : 1;
        chance *= draft.Kind == LocomotionKind.Swimming ? 0.25 : 1;
        bool eared = draft.Ears.Count > 0 && draft.Species.Family != "bovine";
        bool nose = draft.Plan is BodyPlan.Columnar or BodyPlan.Plantigrade or BodyPlan.Unguligrade;
        if (eared || !random.Chance(chance))
        {
            return false;
        }

        double length = head * random.Uniform(0.9, 2.0);
        double radius = head * random.Uniform(0.16, 0.25);
        int style = random.Weighted(stackalloc double[] { 1, 1, 0.7, nose ? 0.35 : 0 });
        draft.Features.Add(style switch
        {
            0 => new FeatureBlueprint(FeatureKind.Horn, 13, 2.6, length, radius, 0, 0.87, -0.09, 0.48, 0.15, 0.25, -0.25, 1, 1),
            1 => new FeatureBlueprint(FeatureKind.Horn, 13, 2.6, length, radius, 0, 0.50, -0.81, 0.32, -0.35, -0.10, 0.10, 1, 1),
            2 => new FeatureBlueprint(FeatureKind.Horn, 13, 2.6, length, radius, 0, 0.24, -0.24, 0.94, 0.65, 0.45, -0.20, 1, 1),
            _ => new FeatureBlueprint(FeatureKind.Horn, 3, 0, length, radius * 1.2, 0.87, 0, 0.48, 0, 0, -0.35, 0, 1, 1),
        });
        return true;
    }

    private static void Tuft(CreatureDraft draft, double head, bool horned, double plenty, RandomStream random)
    {
        bool bird = draft.Species.Family == "avian";
        bool furred = draft.Species.Family is "feline" or "canine";
        if (draft.Kind == LocomotionKind.Swimming || horned || !(bird || furred) || !random.Chance((bird ? 0.45 : 0.2) * plenty))
        {
            return;
        }

        int count = bird ? 5 : 9;
        for (int q = 0; q < count; q++)
        {
            double ring = bird ? 12 + (q * 0.9) : 14 + (q * 1.1);
            double length = head * (bird ? 0.9 : 0.55) * (1 - (0.5 * Math.Abs((q / (count - 1.0)) - 0.35)));
            draft.Features.Add(new FeatureBlueprint(FeatureKind.Tuft, ring, 0, length, head * 0.2, 0.73, 0, -0.68, 0, 0, -0.3, 0, 0.5, 0.7));
        }
    }

    private static void Back(CreatureDraft draft, bool horned, double plenty, RandomStream random)
    {
        bool plain = draft.Kind == LocomotionKind.Swimming || draft.Species.Family is "avian" or "fish";
        bool furred = draft.Species.Family is "canine" or "feline";
        double chance = (plain ? 0 : furred ? 0.12 : 0.3) * plenty;
        int count = random.Integer(7, 13);
        double height = random.Uniform(0.06, 0.13);
        if (!random.Chance(horned ? chance * 0.4 : chance))
        {
            return;
        }

        BodyShape s = draft.Shape;
        for (int q = 0; q < count; q++)
        {
            double ring = 18 + (30.0 * q / (count - 1));
            double length = height * (0.35 + (0.65 * Maths.PortableMath.Sin(Maths.PortableMath.Pi * (q + 0.6) / (count + 0.2)))) * Maths.Scalar.Clamp(s.Top[(int)ring] / 0.12, 0.35, 1.2);
            draft.Features.Add(new FeatureBlueprint(FeatureKind.Spike, ring, 0, length, length * 0.3, 0.88, 0, -0.48, 0, 0, 0, 0, 1, 1));
        }
    }

    private static void InsectHead(CreatureDraft draft, RandomStream random)
    {
        double length = random.Uniform(0.25, 0.5);
        draft.Features.Add(new FeatureBlueprint(FeatureKind.Antenna, 6, 3, length * 1.3, 0.012, 0, 0.76, 0.53, 0.34, -0.35, 0.27, 0.08, 1, 0.6));
        draft.Features.Add(new FeatureBlueprint(FeatureKind.Mandible, 2, 10, 0.11, 0.024, 0, -0.18, 0.95, -0.1, 0, 0, -0.27, 1, 1));
    }
}
