using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Limbs.Attachment;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Gives swimmers, and fish out of water, their fins where the attachment rules put them.</summary>
internal static class FinSampler
{
    /// <summary>Fills in the fins and the tail fin of the draft.</summary>
    public static void Sample(CreatureDraft draft)
    {
        if (draft.Kind == LocomotionKind.Swimming)
        {
            Swim(draft);
        }
        else if (draft.Species.Family == "fish")
        {
            Crest(draft, draft.Stream("fins"));
        }
    }

    private static void Swim(CreatureDraft draft)
    {
        RandomStream random = draft.Stream("fins");
        if (draft.Species.Fins is FinKit kit)
        {
            Own(draft, random, kit);
            return;
        }

        SwimmingPlacement placement = SwimmingRules.Place(LegSampler.Measure(draft), FinAnatomy.Of(draft.Plan), draft.Sockets, draft.Seed.Child("swimmer"));
        double drop = random.Uniform(0.25, 0.6);
        double sweep = random.Uniform(0.4, 0.8);
        foreach (FinPlacement fin in placement.Fins)
        {
            if (!draft.Sockets.TryReserve(fin.Socket, 0))
            {
                continue;
            }

            if (fin.Place == FinPlace.Pectoral)
            {
                bool front = fin.Socket.Ring < BodyGrid.AnchorRing - 2;
                (double length, double width) = draft.Plan switch
                {
                    BodyPlan.Flipper => front ? (0.65, 0.41) : (0.46, 0.42),
                    BodyPlan.Whale => (0.42, 0.45),
                    BodyPlan.Eel => (0.28, 0.55),
                    _ => front ? (0.34, 0.55) : (0.2, 0.55),
                };
                draft.Fins.Add(new FinBlueprint(fin.Place, fin.Style, fin.Socket, length * fin.Scale.X, width * fin.Scale.Z, drop, sweep));
            }
            else
            {
                double height = draft.Plan == BodyPlan.Eel ? 0.13 : fin.Place == FinPlace.Ventral ? 0.12 : draft.Plan == BodyPlan.Whale ? 0.16 : 0.2;
                draft.Fins.Add(new FinBlueprint(fin.Place, fin.Style, fin.Socket, height * fin.Scale.Y, 0, 0, SweepOf(fin.Style)));
            }
        }

        double fork = placement.Tail.Style switch
        {
            TailStyle.Fork => random.Uniform(1.2, 2.2),
            TailStyle.Fan => random.Uniform(-0.5, 0.1),
            TailStyle.Lance => -1,
            TailStyle.Fluke => 1,
            _ => 0,
        };
        double size = placement.Tail.Style switch
        {
            TailStyle.Fork => 0.29 * placement.Tail.Scale.Y,
            TailStyle.Fan => 0.24 * placement.Tail.Scale.Y,
            TailStyle.Lance => 0.15 * placement.Tail.Scale.Y,
            TailStyle.Fluke => 0.34 * placement.Tail.Scale.X,
            _ => 0,
        };
        draft.Tail = new TailBlueprint(placement.Tail.Style, size, fork);
        draft.Shape = StanceSampler.ShapeOf(draft);
    }

    /// <summary>The fins that a species always has.</summary>
    private static void Own(CreatureDraft draft, RandomStream random, FinKit kit)
    {
        foreach (FinSiteKit fin in kit.Fins)
        {
            double length = CreatureDraft.Between(random, fin.Length);
            double width = CreatureDraft.Between(random, fin.Width);
            SocketBlueprint socket = fin.Place switch
            {
                FinPlace.Dorsal => new SocketBlueprint(fin.Ring, 31, fin.Rows, 2),
                FinPlace.Ventral => new SocketBlueprint(fin.Ring, 15, fin.Rows, 2),
                _ => SocketSizing.Centre(fin.Ring, fin.Segment, fin.Rows, 2),
            };
            if (draft.Sockets.TryReserve(socket, 0))
            {
                draft.Fins.Add(new FinBlueprint(fin.Place, fin.Style, socket, length, fin.Place == FinPlace.Pectoral ? width : 0, fin.Drop, fin.Sweep));
            }
        }

        draft.Tail = new TailBlueprint(kit.Tail, CreatureDraft.Between(random, kit.TailSize), CreatureDraft.Between(random, kit.TailFork), kit.TailLobe);
        draft.Shape = StanceSampler.ShapeOf(draft);
    }

    /// <summary>A fish that walks or flies keeps the fin on its back.</summary>
    private static void Crest(CreatureDraft draft, RandomStream random)
    {
        FinStyle style = CreatureDraft.Choose(random, (FinStyle.Sail, 1), (FinStyle.Spiny, 1), (FinStyle.Shark, 1));
        var socket = new SocketBlueprint(random.Integer(24, 30), 31, 2 * random.Integer(4, 7), 2);
        double height = random.Uniform(0.14, 0.26);
        if (draft.Sockets.TryReserve(socket, 0))
        {
            draft.Fins.Add(new FinBlueprint(FinPlace.Dorsal, style, socket, height, 0, 0, SweepOf(style)));
        }
    }

    private static double SweepOf(FinStyle style) => style switch { FinStyle.Sail => 0.35, FinStyle.Shark => 0.9, _ => 0.6 };
}
