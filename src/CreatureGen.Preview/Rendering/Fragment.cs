namespace CreatureGen.Preview.Rendering;

/// <summary>What one surface shows in one pixel.</summary>
internal struct Fragment
{
    /// <summary>Index of the screen triangle.</summary>
    public int Triangle;

    /// <summary>Index of the pixel in the picture, row by row.</summary>
    public int Pixel;

    /// <summary>Samples of the pixel in which it is seen.</summary>
    public int Mask;

    /// <summary>Distance along the camera's axis, metres.</summary>
    public float Depth;

    /// <summary>Weights of the second and third corner of the source triangle.</summary>
    public float B, C;

    /// <summary>Unit normal turned to the viewer, model space.</summary>
    public float NormalX, NormalY, NormalZ;
}
