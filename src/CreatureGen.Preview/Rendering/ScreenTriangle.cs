namespace CreatureGen.Preview.Rendering;

/// <summary>A triangle as it lies in the picture, wound so that its inside is to the right of its edges with y down.</summary>
internal struct ScreenTriangle
{
    /// <summary>Corners in 1/256 pixel, y down.</summary>
    public int X0, Y0, X1, Y1, X2, Y2;

    /// <summary>First and last pixel that it may cover, inside the picture.</summary>
    public int MinX, MinY, MaxX, MaxY;

    /// <summary>The triangle of the mesh it is or is cut from: index of the first of its three indices.</summary>
    public int Source;

    /// <summary>Part of the mesh.</summary>
    public int Part;

    /// <summary>1 when seen from the front, −1 from the back.</summary>
    public float Side;

    /// <summary>1/depth at the middle of pixel (MinX, MinY) and its change per pixel.</summary>
    public float Depth, DepthX, DepthY;

    /// <summary>Bounds of 1/depth over the triangle.</summary>
    public float DepthMin, DepthMax;

    /// <summary>Weight of the source's second corner over depth at the middle of pixel (MinX, MinY), and its change per pixel.</summary>
    public float B, BX, BY;

    /// <summary>Weight of the source's third corner over depth, likewise.</summary>
    public float C, CX, CY;
}
