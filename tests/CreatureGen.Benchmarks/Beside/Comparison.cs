namespace CreatureGen.Benchmarks.Beside;

/// <summary>A row of work, what it is, and how long it may take.</summary>
/// <param name="Row">The probe's name of it.</param>
/// <param name="Work">What is done.</param>
/// <param name="Goal">Part of the earlier commit's time that the median over items may take; null where none is set.</param>
internal sealed record Comparison(string Row, string Work, double? Goal)
{
    /// <summary>All of them.</summary>
    public static Comparison[] All { get; } =
    {
        new("blueprint", "blueprint from a seed", 0.3),
        new("creature", "creature from a blueprint", 0.55),
        new("fine", "creature of at most 16,000 triangles", null),
        new("budget", "creature cut to 6,000 triangles", 0.3),
        new("levels", "levels of detail", 0.05),
        new("profile", "what is worked out before a creature moves", null),
        new("stand", "update, four legs, standing, of a crowd of 512", 0.7),
        new("walk", "update, four legs, walking", 0.7),
        new("far", "the same seen from afar, over the update in full", 0.15),
        new("crawl", "update, no legs, crawling", null),
        new("fly", "update, flying", null),
        new("swim", "update, swimming", null),
        new("blend", "blend of two poses", 0.5),
        new("mixer", "pose mixer, two poses", 0.18),
        new("chain", "local to model", null),
        new("skinning", "skinning of a creature's vertices", 0.55),
        new("meshground", "ground of 100,000 triangles built", 0.275),
        new("glb", "GLB without textures, in memory", 0.7),
        new("atlas", "GLB with an atlas of 1024 texels, baked and compressed", 0.3),
    };
}
