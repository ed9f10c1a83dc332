using System.Numerics;
using CreatureGen;
using CreatureGen.Engines;
using CreatureGen.Motion;
using CreatureGen.Skinning;

namespace OnScreen;

/// <summary>A program that shows a creature that walks, as a game has it: outside the library's namespaces, with four of them in use.</summary>
internal static class ProgramOnScreen
{
    /// <summary>Makes a creature and its buffers, and lets it go for some frames.</summary>
    /// <returns>How far it went, metres, and whether there was anything to draw.</returns>
    public static (float Way, bool Drawn) Run(ulong seed, int frames)
    {
        var creature = CreatureGenerator.Generate(seed);
        var mesh = creature.Mesh.For(EngineAxes.Unity);
        var animator = new CreatureAnimator(creature);
        var settings = animator.Settings;
        settings.Walking = settings.Walking with { Lift = 1.2f };
        animator.Settings = settings;
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        for (int frame = 0; frame < frames; frame++)
        {
            animator.Update(1f / 60f, new MotionInput(Speed: creature.DefaultSpeed), FlatGround.Level);
            SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
        }

        return (animator.Root.Position.Length(), mesh.VertexCount > 0 && matrices[0] != default);
    }
}
