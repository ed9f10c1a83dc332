using System;
using System.IO;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GltfToolsTests
{
    [Fact]
    public void The_lock_file_names_packages_but_no_place_to_get_them_from()
    {
        string text = File.ReadAllText(Path.Combine(GltfTools.Folder, "package-lock.json"));
        Assert.Contains("\"node_modules/gltf-validator\"", text, StringComparison.Ordinal);
        Assert.Contains("\"integrity\"", text, StringComparison.Ordinal);
        Assert.DoesNotContain("\"resolved\"", text, StringComparison.Ordinal);
    }
}
