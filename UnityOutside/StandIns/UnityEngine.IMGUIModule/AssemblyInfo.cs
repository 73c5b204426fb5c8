[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("UnityEditor.CoreModule")]
[assembly: InternalsVisibleTo("UnityEditor.AssetPipelineEditorModule")]
