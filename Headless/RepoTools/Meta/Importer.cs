namespace FastPoints.RepoTools.Meta;

public sealed record Importer(string Name, bool IsFolder, string Settings)
{
    private const string NoSettings = "";

    public static Importer Of(string asset, bool isFolder)
    {
        if (isFolder)
            return new Importer("DefaultImporter", true, NoSettings);
        if (asset == "package.json")
            return new Importer("PackageManifestImporter", false, NoSettings);
        switch (Path.GetExtension(asset).ToLowerInvariant())
        {
            case ".cs":
                return new Importer("MonoImporter", false,
                    "  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n");
            case ".asmdef":
                return new Importer("AssemblyDefinitionImporter", false, NoSettings);
            case ".asmref":
                return new Importer("AssemblyDefinitionReferenceImporter", false, NoSettings);
            case ".shader":
                return new Importer("ShaderImporter", false, "  defaultTextures: []\n  nonModifiableTextures: []\n");
            case ".compute":
                return new Importer("ComputeShaderImporter", false, NoSettings);
            case ".hlsl":
            case ".cginc":
                return new Importer("ShaderIncludeImporter", false, NoSettings);
            case ".png":
            case ".jpg":
                // Pictures that the editor shows: as they are, in any size.
                return new Importer("TextureImporter", false, "  serializedVersion: 13\n  mipmaps:\n    enableMipMap: 0\n"
                    + "  nPOTScale: 0\n  alphaIsTransparency: 1\n  textureType: 2\n");
            case ".md":
            case ".json":
            case ".txt":
            case ".xml":
            case ".html":
            case ".bytes":
                return new Importer("TextScriptImporter", false, NoSettings);
            case ".asset":
                return new Importer("NativeFormatImporter", false, "  mainObjectFileID: 11400000\n");
            case ".mat":
                return new Importer("NativeFormatImporter", false, "  mainObjectFileID: 2100000\n");
            case ".prefab":
                return new Importer("PrefabImporter", false, NoSettings);
            default:
                return new Importer("DefaultImporter", false, NoSettings);
        }
    }
}
