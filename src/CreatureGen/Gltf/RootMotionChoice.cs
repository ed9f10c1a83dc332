namespace CreatureGen.Gltf;

/// <summary>Who moves a creature while a clip plays.</summary>
public enum RootMotionChoice
{
    /// <summary>The game, at the speed that is told with the clip: all clips stay over their point of the ground.</summary>
    InPlace,

    /// <summary>The clip: its root joint travels and turns. In clips that loop it ends where the next round begins, ahead of where it began.</summary>
    Travels,
}
