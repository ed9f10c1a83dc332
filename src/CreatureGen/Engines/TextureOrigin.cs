namespace CreatureGen.Engines;

/// <summary>Where texture coordinates are (0, 0).</summary>
public enum TextureOrigin
{
    /// <summary>At the top left of the picture, as the arrays of a creature have it: v points down.</summary>
    TopLeft,

    /// <summary>At the bottom left of the picture: v points up.</summary>
    BottomLeft,
}
