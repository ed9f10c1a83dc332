using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Draws the fins of swimmers and of fish out of water.</summary>
internal static class FinSampler
{
    /// <summary>Fills in the fins of the draft.</summary>
    public static void Sample(CreatureDraft draft)
    {
        RandomStream random = draft.Stream("fins");
        bool fish = draft.Family.Body == "fish";
        switch (draft.Plan)
        {
            case BodyPlan.Eel:
                Midline(draft, FinPlace.Dorsal, random.Chance(0.5) ? FinStyle.Sail : FinStyle.Spiny, 24, 22, random.Uniform(0.10, 0.16));
                Pectoral(draft, 20, 10, random.Uniform(0.22, 0.34), random.Uniform(0.45, 0.65), random);
                break;
            case BodyPlan.Whale:
                Midline(draft, FinPlace.Dorsal, FinStyle.Shark, 33, 8, random.Uniform(0.12, 0.2));
                Pectoral(draft, 24, 10, random.Uniform(0.35, 0.5), random.Uniform(0.4, 0.5), random);
                break;
            case BodyPlan.Flipper:
                if (random.Chance(0.35))
                {
                    Midline(draft, FinPlace.Dorsal, FinStyle.Shark, 32, 8, random.Uniform(0.08, 0.16));
                }

                Pectoral(draft, 25, 10, random.Uniform(0.55, 0.75), random.Uniform(0.36, 0.46), random);
                Pectoral(draft, 41, 10, random.Uniform(0.38, 0.55), 0.42, random);
                break;
            case BodyPlan.Fish:
                Dorsals(draft, random);
                if (random.Chance(0.6))
                {
                    Midline(draft, FinPlace.Ventral, FinStyle.Shark, 37, 6, 0.13);
                }

                Pectoral(draft, 22, 10, random.Uniform(0.26, 0.42), random.Uniform(0.45, 0.65), random);
                if (random.Chance(0.55))
                {
                    Pectoral(draft, 34, 12, random.Uniform(0.16, 0.24), 0.55, random);
                }

                break;
            default:
                if (fish)
                {
                    Midline(draft, FinPlace.Dorsal, CreatureDraft.Choose(random, (FinStyle.Sail, 1), (FinStyle.Spiny, 1), (FinStyle.Shark, 1)), random.Integer(24, 30), 2 * random.Integer(4, 7), random.Uniform(0.14, 0.26));
                }

                break;
        }
    }

    private static void Dorsals(CreatureDraft draft, RandomStream random)
    {
        if (random.Chance(0.5))
        {
            FinStyle style = CreatureDraft.Choose(random, (FinStyle.Sail, 1), (FinStyle.Spiny, 1), (FinStyle.Shark, 1));
            Midline(draft, FinPlace.Dorsal, style, random.Integer(24, 30), CreatureDraft.Choose(random, (8, 1), (12, 1), (16, 1)), random.Uniform(0.14, 0.28));
            return;
        }

        Midline(draft, FinPlace.Dorsal, CreatureDraft.Choose(random, (FinStyle.Shark, 1), (FinStyle.Spiny, 1), (FinStyle.Sail, 0.6)), random.Integer(23, 25), 8, random.Uniform(0.15, 0.25));
        Midline(draft, FinPlace.Dorsal, FinStyle.Shark, 36, 6, random.Uniform(0.10, 0.16));
    }

    private static void Midline(CreatureDraft draft, FinPlace place, FinStyle style, int ring, int rows, double height)
    {
        int end = Math.Min(ring + rows, 47);
        rows = end - ring;
        rows -= rows % 2;
        var socket = new SocketBlueprint(ring, place == FinPlace.Dorsal ? 31 : 15, rows, 2);
        if (rows >= 4 && draft.Sockets.TryTake(socket, 0))
        {
            double sweep = style switch { FinStyle.Sail => 0.35, FinStyle.Shark => 0.9, _ => 0.6 };
            draft.Fins.Add(new FinBlueprint(place, style, socket, height, 0, 0, sweep));
        }
    }

    private static void Pectoral(CreatureDraft draft, int ring, double segment, double length, double width, RandomStream random)
    {
        var socket = new SocketBlueprint(ring - 2, (int)segment - 1, 4, 2);
        double drop = random.Uniform(0.25, 0.6);
        double sweep = random.Uniform(0.4, 0.8);
        if (draft.Sockets.TryTake(socket, 0))
        {
            draft.Fins.Add(new FinBlueprint(FinPlace.Pectoral, FinStyle.Paddle, socket, length, width, drop, sweep));
        }
    }
}
