namespace CreatureGen.Animation.Ragdolls;
internal static class RagdollTuning { public static float Repair = 0.2f; public static float Substep = 1f/480f; public static int Rounds = 1; public static float Stout = 0.35f; public static float Arm = 1.2f; public static float Mass = 0.004f; }
