using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Draws the wings of fliers.</summary>
internal static class WingSampler
{
    /// <summary>Fills in the wings of the draft.</summary>
    public static void Sample(CreatureDraft draft)
    {
        RandomStream random = draft.Stream("wings");
        if (draft.Plan == BodyPlan.Flapping)
        {
            bool bat = draft.Family.Body == "avian" ? random.Chance(0.12) : random.Chance(0.72);
            double span = random.Uniform(1.15, 1.6) * Math.Max(draft.TorsoLength, 0.8);
            double chord = (bat ? 0.40 : 0.36) * span * random.Uniform(0.9, 1.15);
            var socket = new SocketBlueprint(24, 5, 6, 2);
            if (draft.Sockets.TryTake(socket, 0))
            {
                draft.Wings.Add(new WingBlueprint(bat ? WingStyle.Bat : WingStyle.Feathered, socket, span, chord, random.Uniform(0.42, 0.75), random.Uniform(0.05, 0.25)));
            }
        }
        else if (draft.Plan == BodyPlan.Buzzing)
        {
            double front = random.Uniform(0.85, 1.05);
            double rear = random.Uniform(0.6, 0.72);
            draft.InsectWings.Add(new InsectWingBlueprint(26, 2.6, front, 0.20 * random.Uniform(0.9, 1.25), Scalar.Radians(-6), Scalar.Radians(36)));
            draft.InsectWings.Add(new InsectWingBlueprint(30, 2.6, rear, 0.16 * random.Uniform(0.9, 1.25), Scalar.Radians(-36), Scalar.Radians(26)));
        }
    }
}
