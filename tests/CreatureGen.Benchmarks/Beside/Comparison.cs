namespace CreatureGen.Benchmarks.Beside;

/// <summary>A row of work, what it is, and how long it may take.</summary>
/// <param name="Row">The probe's name of it.</param>
/// <param name="Work">What is done.</param>
/// <param name="Goal">Part of the earlier commit's time that the median over items may take; null where none is set.</param>
/// <param name="Beside">Who does the same or something near it; null where nobody does.</param>
internal sealed record Comparison(string Row, string Work, double? Goal, PeerWork? Beside = null)
{
    /// <summary>All of them.</summary>
    public static Comparison[] All { get; } =
    {
        new("blueprint", "blueprint from a seed", 0.3),
        new("creature", "creature from a blueprint", 0.55),
        new("fine", "creature of at most 16,000 triangles", null),
        new("budget", "creature cut to 6,000 triangles", 0.3),
        new("levels", "levels of detail", 0.05, new PeerWork(Peer.Meshoptimizer, "levels", "three simplifications, each ordered for caches")),
        new("profile", "what is worked out before a creature moves", null),
        new("stand", "update, four legs, standing, of a crowd of 512", 0.7),
        new("walk", "update, four legs, walking", 0.7, new PeerWork(Peer.Ozz, "walk", "two clips sampled and blended, four legs, aim, skin matrices, of a crowd of 512")),
        new("far", "the same seen from afar, over the update in full", 0.15),
        new("crowd", "update, four legs, walking, in crowds of one creature each", 0.5),
        new("crawl", "update, no legs, crawling", null),
        new("fly", "update, flying", null),
        new("swim", "update, swimming", null),
        new("blend", "blend of two poses", 0.5, new PeerWork(Peer.Ozz, "blend", "blend of two poses with the rest pose")),
        new("mixer", "pose mixer, two poses", 0.18, new PeerWork(Peer.Ozz, "blend", "blend of two poses with the rest pose")),
        new("chain", "local to model", null, new PeerWork(Peer.Ozz, "chain", "local to model matrices")),
        new("twobone", "leg of two bones", null, new PeerWork(Peer.Ozz, "twobone", "leg of two bones")),
        new("pantograph", "leg of three bones", null, new PeerWork(Peer.Ozz, "twobone", "leg of two bones")),
        new("skinning", "skinning of a creature's vertices", 0.55, new PeerWork(Peer.Ozz, "skinning", "skinning with four influences")),
        new("meshground", "ground of 100,000 triangles built", 0.275),
        new("glb", "GLB without textures, in memory", 0.7),
        new("atlas", "GLB with an atlas of 1024 texels, baked and compressed", 0.3),
    };
}

/// <summary>The work of a peer that a row stands beside.</summary>
/// <param name="Peer">Whose.</param>
/// <param name="Row">Its program's name of it.</param>
/// <param name="Work">What is done.</param>
internal sealed record PeerWork(Peer Peer, string Row, string Work);
