using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("UnityEditor.AssetPipelineEditorModule")]
