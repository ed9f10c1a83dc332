namespace CreatureGen.Gltf;

/// <summary>How one number of an accessor is stored.</summary>
internal enum ComponentFormat
{
    /// <summary>IEEE 754 single precision.</summary>
    Float,

    /// <summary>Unsigned 8-bit integer.</summary>
    Byte,

    /// <summary>Unsigned 16-bit integer.</summary>
    Short,

    /// <summary>Unsigned 16-bit integer that stands for a fraction of 65535.</summary>
    ShortFraction,

    /// <summary>Unsigned 32-bit integer.</summary>
    Integer,
}

/// <summary>How many numbers make an element of an accessor.</summary>
internal enum ElementShape
{
    Scalar,
    Vector2,
    Vector3,
    Vector4,
    Matrix4,
}

/// <summary>What the graphics card takes a buffer view for.</summary>
internal enum BufferTarget
{
    /// <summary>Not for the graphics card.</summary>
    None,

    /// <summary>Vertex attributes.</summary>
    Vertices,

    /// <summary>Vertex indices.</summary>
    Indices,
}

/// <summary>A list of equal elements in the binary chunk, alone in a buffer view of the same number.</summary>
/// <param name="Index">Its number, and that of its buffer view.</param>
/// <param name="Offset">Its first byte in the binary chunk, a multiple of four.</param>
/// <param name="Count">Number of elements.</param>
/// <param name="Shape">Numbers of an element.</param>
/// <param name="Format">Storage of a number.</param>
/// <param name="Target">What it is for.</param>
internal sealed record Accessor(int Index, int Offset, int Count, ElementShape Shape, ComponentFormat Format, BufferTarget Target)
{
    /// <summary>Bytes of its elements, without padding.</summary>
    public int ByteLength => checked(Count * ElementSize(Shape, Format));

    /// <summary>Bytes of one element.</summary>
    public static int ElementSize(ElementShape shape, ComponentFormat format) => ComponentCount(shape) * ComponentSize(format);

    private static int ComponentCount(ElementShape shape) => shape switch
    {
        ElementShape.Scalar => 1,
        ElementShape.Vector2 => 2,
        ElementShape.Vector3 => 3,
        ElementShape.Vector4 => 4,
        _ => 16,
    };

    private static int ComponentSize(ComponentFormat format) => format switch
    {
        ComponentFormat.Byte => 1,
        ComponentFormat.Short or ComponentFormat.ShortFraction => 2,
        _ => 4,
    };
}
